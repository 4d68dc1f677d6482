package coffee.floor;

/** Runs that may be. */
testsuite CautionTest for Caution {
    test tellsAtOnce {
        input {
            seen: <clear, Tk, tooClose, Tk, Tk, clear, Tk>;
        }
        expect {
            front: <clear, Tk, tooClose, Tk, Tk, clear, Tk>;
        }
    }

    test keepsGoodNewsBack {
        input {
            seen: <clear, Tk, tooClose, Tk, Tk, clear, Tk>;
        }
        expect {
            front: <Tk, tooClose, Tk, 2*Tk>;
        }
    }
}
