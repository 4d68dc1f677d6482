package coffee.fig3;

/** Two runs that Fig. 3 allows, both inside what is drawn. */
testsuite AvoidCrashTest for AvoidCrash {
    /** Waits once; at the second meeting it makes room. */
    test waitsThenMakesRoom {
        input {
            frontUS: <tooClose, Tk, clear, Tk, tooClose, Tk>;
        }
        expect {
            cmd: <fwd, Tk, stop, Tk, fwd, Tk, backRight, Tk>;
        }
    }

    /** The same approach, the other choice. */
    test makesRoom {
        input {
            frontUS: <tooClose, Tk>;
        }
        expect {
            cmd: <fwd, Tk, backRight, Tk>;
        }
    }
}
