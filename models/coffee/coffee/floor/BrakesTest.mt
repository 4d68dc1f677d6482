package coffee.floor;

/** A run that may be. */
testsuite BrakesTest for Brakes {
    test stops {
        input {
            cmd: <fwd, Tk, stop, Tk>;
        }
        expect {
            leftSpeed: <360, Tk, 0, Tk>;
            rightSpeed: <120, Tk, 0, Tk>;
        }
    }
}
