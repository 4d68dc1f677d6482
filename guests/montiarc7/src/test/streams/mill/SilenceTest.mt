package mill;

testsuite SilenceTest for Silence {
    test theOrderOfTheTextDecides {
        input {
            x: <Tk, Tk, 1, Tk, 3, Tk, 9, Tk, 1, Tk, 9, Tk, 7, Tk, 2, Tk>;
            quiet: <Tk, true, Tk, Tk, true, Tk, true, Tk, false, Tk, Tk, false, Tk, true, Tk>;
        }
        expect {
            out: <0, Tk, 1, Tk, 4, Tk, 2, Tk, 1, Tk, 3, Tk, 2, Tk, 2, Tk, 4, Tk>;
        }
    }
}
