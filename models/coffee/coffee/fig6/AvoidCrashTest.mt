package coffee.fig6;

/** The scenario of Fig. 1 from the view of one controller, slice by slice. */
testsuite AvoidCrashTest for AvoidCrash {
    /** Without coffee: make room, return to the line, and be ready to do it again. */
    test makesRoomAndReturns {
        input {
            frontUS: <clear, Tk, tooClose, Tk, tooClose, 3*Tk, tooClose, Tk, clear, 3*Tk, tooClose,
                    Tk>;
            timerSig: <4*Tk, alert, 6*Tk>;
            ls: <7*Tk, lost, Tk, ok, 2*Tk>;
            gotCoffee: <10*(false, Tk)>;
        }
        expect {
            cmd: <fwd, 2*Tk, backRight, 3*Tk, stop, 2*Tk, fwd, 3*Tk, backRight, Tk>;
            timerCmd: <2*Tk, delay, 8*Tk, delay, Tk>;
        }
    }

    /** With coffee: wait until the way is clear. */
    test waits {
        input {
            frontUS: <clear, Tk, tooClose, Tk, tooClose, Tk, clear, 2*Tk>;
            gotCoffee: <5*(true, Tk)>;
        }
        expect {
            cmd: <fwd, 2*Tk, stop, 2*Tk, fwd, 2*Tk>;
            timerCmd: <6*Tk>;
        }
    }
}
