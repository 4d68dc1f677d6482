package coffee.floor;

testsuite CalmTest for Calm {
    /** Two seconds without a break, counted anew after each. */
    test waits {
        input {
            seen: <19*(clear, Tk), Tk, 19*(clear, Tk), tooClose, Tk, 21*(clear, Tk)>;
        }
        expect {
            front: <39*Tk, tooClose, Tk, 19*Tk, 2*(clear, Tk)>;
        }
    }
}
