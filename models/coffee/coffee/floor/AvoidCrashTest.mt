package coffee.floor;

testsuite AvoidCrashTest for AvoidCrash {
    /** As Fig. 6, and it tells. */
    test makesRoomAndReturns {
        input {
            frontUS: <clear, Tk, tooClose, 4*Tk, clear, 3*Tk>;
            timerSig: <3*Tk, alert, 5*Tk>;
            ls: <6*Tk, lost, Tk, ok, Tk>;
            gotCoffee: <8*(false, Tk)>;
        }
        expect {
            cmd: <fwd, 2*Tk, backRight, 2*Tk, stop, 2*Tk, fwd, 2*Tk>;
            timerCmd: <2*Tk, delay, 7*Tk>;
            doing: <"driving", 2*Tk, "backing", 2*Tk, "remote", 2*Tk, "returning", 2*Tk, "driving",
                    Tk>;
        }
    }

    test waits {
        input {
            frontUS: <tooClose, Tk, tooClose, Tk, clear, Tk>;
            gotCoffee: <3*(true, Tk)>;
        }
        expect {
            cmd: <fwd, Tk, stop, 2*Tk, fwd, Tk>;
            doing: <"driving", Tk, "waiting", 2*Tk, "driving", Tk>;
        }
    }
}
