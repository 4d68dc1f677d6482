package coffee.fig5;

/** Fig. 5 along both of its branches. */
testsuite AvoidCrashTest for AvoidCrash {
    /** Backs off, stands, and returns when the front is clear. */
    test makesRoom {
        input {
            frontUS: <tooClose, 2*Tk, clear, Tk>;
            timerSig: <Tk, alert, 2*Tk>;
        }
        expect {
            cmd: <fwd, Tk, backRight, Tk, stop, Tk, fwd, Tk>;
            timerCmd: <Tk, delay, 3*Tk>;
        }
    }

    /** Waits on the line and needs no timer. */
    test waits {
        input {
            frontUS: <tooClose, Tk, clear, Tk>;
        }
        expect {
            cmd: <fwd, Tk, stop, Tk, fwd, Tk>;
            timerCmd: <3*Tk>;
        }
    }
}
