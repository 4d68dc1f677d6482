package mill;

testsuite LimitsTest for Limits {
    test areThose {
        input {
            a: <3, Tk, 2147483647, Tk, -4, Tk>;
            b: <5, Tk, 0, Tk, -2, Tk>;
        }
        expect {
            least: <3, Tk, 1, Tk, -4, Tk>;
            most: <5, Tk, 2147483647, Tk, -2, Tk>;
            size: <2, Tk, 2147483647, Tk, 2, Tk>;
            full: <false, Tk, true, Tk, false, Tk>;
            empty: <false, Tk, true, Tk, false, Tk>;
            letter: <'x', Tk, Tk, 'x', Tk>;
        }
    }
}
