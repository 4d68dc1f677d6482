package coffee.floor;

testsuite BrewTest for Brew {
    /** The fetcher is held from the moment its cup is felt until it is full. */
    test holdsTheFetcher {
        input {
            cup: <false, Tk, 8*(true, Tk), false, Tk, true, Tk>;
            ready: <true, Tk, false, Tk, true, Tk, 4*(false, Tk), 4*(true, Tk)>;
            timerSig: <4*Tk, alert, Tk, alert, 6*Tk>;
        }
        expect {
            finger: <halt, 3*Tk, extend, 2*Tk, retract, Tk, halt, 5*Tk, extend, Tk>;
            timerCmd: <3*Tk, delay, 2*Tk, delay, 6*Tk, delay, Tk>;
            order: <2*Tk, hold, 6*Tk, go, 3*Tk, hold, Tk>;
        }
    }
}
