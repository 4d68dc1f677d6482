package coffee.floor;

/** A run that may be. */
testsuite ObedienceTest for Obedience {
    test stands {
        input {
            wanted: <fwd, Tk, Tk, fwd, Tk, Tk>;
            order: <Tk, hold, 2*Tk, go, Tk>;
        }
        expect {
            cmd: <fwd, Tk, stop, 2*Tk, fwd, Tk>;
        }
    }
}
