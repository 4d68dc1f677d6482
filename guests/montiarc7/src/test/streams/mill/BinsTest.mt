package mill;

testsuite BinsTest for mill.Bins {
    test keepEachForASlice {
        input {
            i: <7, Tk, 8, Tk, Tk>;
        }
        expect {
            o: <2, Tk, 1, Tk, 7, Tk, 8, Tk>;
        }
    }
}
