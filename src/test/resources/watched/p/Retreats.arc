package p;

/** Who is stopped twice makes room: the rover does not. */
component Retreats(Integer least) {
    timing causalsync;

    port in Boolean pressed, out Integer speed;

    <<completion = "output">> automaton stops {
        state far, near;

        initial far / {speed = ?};

        far -> near {pressed == true} / {speed = ?};
        near {pressed == true} / {speed = -least};
    }

    <<completion = "output", violated = "continue">> automaton tells {
        state far, near;

        initial far / {speed = ?};

        far -> near {pressed == true} / {speed = ?};
        near {pressed == true} / {speed = -least};
    }
}
