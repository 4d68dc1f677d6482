package coffee.fetcher;

testsuite DriveTest for Drive {
    test steers {
        input {
            cmd: <fwd, 4*Tk>;
            drift: <2*(none, Tk), left, Tk, right, Tk>;
        }
        expect {
            leftSpeed: <360, Tk, 360, Tk, 360, Tk, 120, Tk>;
            rightSpeed: <360, Tk, 360, Tk, 120, Tk, 360, Tk>;
        }
    }

    /** A speed is sent when it changes; the motors keep it. */
    test obeys {
        input {
            cmd: <Tk, fwd, Tk, backRight, 2*Tk, stop, 2*Tk, backRight, Tk, fwd, Tk, stop, Tk>;
            drift: <9*(none, Tk)>;
        }
        expect {
            leftSpeed: <Tk, 360, Tk, -360, 2*Tk, 0, 2*Tk, -360, Tk, 360, Tk, 0, Tk>;
            rightSpeed: <Tk, 360, Tk, -120, 2*Tk, 0, 2*Tk, -120, Tk, 360, Tk, 0, Tk>;
        }
    }
}
