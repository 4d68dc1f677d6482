package coffee.floor;

testsuite DriveTest for Drive {
    /** Off the line it turns to where it saw it last. */
    test findsTheLineAgain {
        input {
            cmd: <fwd, 6*Tk>;
            drift: <none, Tk, left, Tk, 2*(none, Tk), right, Tk, none, Tk>;
            ls: <2*(ok, Tk), lost, Tk, 2*(ok, Tk), lost, Tk>;
        }
        expect {
            leftSpeed: <4*(360, Tk), 120, Tk, 0, Tk>;
            rightSpeed: <360, Tk, 120, Tk, 0, Tk, 3*(360, Tk)>;
        }
    }

    /** An arc, straight back, an arc the other way; then it stands, told to or not. */
    test makesRoom {
        input {
            cmd: <backRight, 27*Tk, stop, Tk>;
            drift: <28*(none, Tk)>;
            ls: <28*(lost, Tk)>;
        }
        expect {
            leftSpeed: <-360, 8*Tk, -360, 14*Tk, -120, 4*Tk, 0, Tk, 0, Tk>;
            rightSpeed: <-120, 8*Tk, -360, 14*Tk, -360, 4*Tk, 0, Tk, 0, Tk>;
        }
    }

    /** Back on the line it turns only when the nose is across. */
    test returns {
        input {
            cmd: <backRight, Tk, stop, Tk, fwd, 6*Tk>;
            drift: <3*(none, Tk), none, Tk, right, Tk, none, Tk, left, Tk, none, Tk>;
            ls: <4*(lost, Tk), 4*(ok, Tk)>;
        }
        expect {
            leftSpeed: <-360, Tk, 0, Tk, 360, 2*Tk, 360, 2*Tk, 360, Tk, 360, Tk>;
            rightSpeed: <-120, Tk, 0, Tk, 360, 2*Tk, 360, 2*Tk, 120, Tk, 360, Tk>;
        }
    }
}
