package yard;

/** Nothing is near: that is up to the world. */
component Far {
    timing instant;

    port in Integer[0..255] distance;

    <<completion = "error", violated = "stop">> automaton {
        state far;

        initial far;

        far [distance > 20];
    }
}
