package coffee.meeting;

testsuite CourtesyTest for Courtesy {
    /** The one with coffee waits, and goes on as soon as the other one makes room. */
    test goesOnOnceThereIsRoom {
        input {
            empty: <Tk, Tk, backRight, Tk>;
        }
        expect {
            loaded: <fwd, Tk, stop, Tk, fwd, Tk>;
        }
    }

    /** There is room already: whoever has coffee need not stop. */
    test goesOnWhereThereIsRoom {
        input {
            empty: <Tk, backRight, Tk>;
        }
        expect {
            loaded: <fwd, Tk, fwd, Tk>;
        }
    }
}
