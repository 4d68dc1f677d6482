package p;

/** Who is stopped stands. */
component Stands {
    timing causalsync;

    port in Boolean pressed, out Integer speed;

    <<completion = "output">> automaton {
        state any;

        initial any / {speed = ?};

        any {pressed == true} / {speed = 0};
    }
}
