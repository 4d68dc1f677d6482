package mill;

testsuite MillTest for Mill {
    test partsWorkInOneSlice {
        input {
            press: <ON, Tk, Tk, OFF, Tk>;
        }
        expect {
            open: <true, Tk, Tk, Tk>;
            count: <0, Tk, Tk, Tk, 2, Tk>;
        }
    }
}
