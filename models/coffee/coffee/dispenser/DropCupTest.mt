package coffee.dispenser;

testsuite DropCupTest for DropCup {
    /** No cups, no motion; then one cup for each of two fetchers. */
    test oneCupEach {
        input {
            below: <clear, Tk, tooClose, Tk, tooClose, 4*Tk, tooClose, Tk, clear, Tk, tooClose, Tk>;
            cups: <true, Tk, false, Tk, 7*(true, Tk)>;
            timerSig: <4*Tk, alert, Tk, alert, 4*Tk>;
        }
        expect {
            slide: <halt, 3*Tk, extend, 2*Tk, retract, Tk, halt, 3*Tk, extend, Tk>;
            timerCmd: <3*Tk, delay, 2*Tk, delay, 4*Tk, delay, Tk>;
        }
    }
}
