package coffee.meeting;

/** The scenario of Fig. 1. */
testsuite MeetingTest for Meeting {
    /** The fetcher without coffee makes room and returns to the line; the one with coffee waits. */
    test coffeeHasRightOfWay {
        expect {
            emptyCmd: <fwd, 4*Tk, backRight, 3*Tk, stop, 4*Tk, fwd, 3*Tk>;
            loadedCmd: <fwd, 4*Tk, stop, 5*Tk, fwd, 5*Tk>;
            emptyLine: <ok, 5*Tk, lost, 7*Tk, ok, 2*Tk>;
        }
    }
}
