package coffee.preparer;

testsuite BrewTest for Brew {
    /** A cup on a cold machine waits; a full one is not filled again. */
    test oneCoffeePerCup {
        input {
            cup: <false, Tk, 8*(true, Tk), false, Tk, true, Tk>;
            ready: <true, Tk, false, Tk, true, Tk, 4*(false, Tk), 4*(true, Tk)>;
            timerSig: <4*Tk, alert, Tk, alert, 6*Tk>;
        }
        expect {
            finger: <halt, 3*Tk, extend, 2*Tk, retract, Tk, halt, 5*Tk, extend, Tk>;
            timerCmd: <3*Tk, delay, 2*Tk, delay, 6*Tk, delay, Tk>;
        }
    }
}
