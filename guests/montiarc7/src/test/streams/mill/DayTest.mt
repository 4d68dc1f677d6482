package mill;

testsuite DayTest for Day {
    test passesOn {
        input {
            i: <5, Tk, Tk, 6, Tk>;
        }
        expect {
            o: <5, Tk, Tk, 6, Tk>;
        }
    }
}
