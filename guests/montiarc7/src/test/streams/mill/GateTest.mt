package mill;

testsuite GateTest for Gate(3) {
    // A press opens; one more narrows once it was opened twice; what blocks it shuts it.
    test opensAndShuts {
        input {
            press: <ON, Tk, OFF, Tk, ON, Tk, ON, Tk, Tk, ON, Tk>;
            blocked: <5*Tk, true, Tk>;
        }
        expect {
            open: <true, Tk, Tk, true, Tk, 3*Tk>;
            count: <0, Tk, Tk, 2, Tk, Tk, 2, Tk, Tk, 4, Tk>;
        }
    }
}
