package coffee.floor;

testsuite HaltTest for Halt {
    test passesOn {
        input {
            wanted: <fwd, 2*Tk, stop, Tk, backRight, Tk>;
            order: <4*Tk>;
        }
        expect {
            cmd: <fwd, 2*Tk, stop, Tk, backRight, Tk>;
        }
    }

    /** What was wanted before or meanwhile is made good. */
    test holds {
        input {
            wanted: <fwd, 4*Tk, stop, Tk, Tk, fwd, 3*Tk>;
            order: <Tk, hold, 2*Tk, go, Tk, hold, 4*Tk, go, Tk>;
        }
        expect {
            cmd: <fwd, Tk, stop, 2*Tk, fwd, Tk, stop, 4*Tk, fwd, Tk>;
        }
    }
}
