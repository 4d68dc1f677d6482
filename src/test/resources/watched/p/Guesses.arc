package p;

/** Follows more and more runs, and forbids nothing. */
component Guesses {
    timing causalsync;

    port in Boolean pressed, out Integer speed;

    <<completion = "output">> automaton {
        state any;
        variable Integer n = 1;

        initial any / {speed = ?};

        any {pressed == ?} / {speed = ?, n = 2 * n};
        any {pressed == ?} / {speed = ?, n = 2 * n + 1};
    }
}
