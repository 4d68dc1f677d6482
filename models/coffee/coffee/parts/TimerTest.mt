package coffee.parts;

testsuite TimerTest for Timer(3) {
    test rings {
        input {
            timerCmd: <Tk, delay, 5*Tk>;
        }
        expect {
            timerSig: <4*Tk, alert, 3*Tk>;
        }
    }

    /** The second delay counts. */
    test startsAnew {
        input {
            timerCmd: <delay, Tk, delay, 5*Tk>;
        }
        expect {
            timerSig: <4*Tk, alert, 3*Tk>;
        }
    }
}
