package yard;

/** What is seen is a distance: that is always so. */
component Always {
    timing instant;

    port in Integer[0..255] distance;

    <<completion = "error">> automaton {
        state far;

        initial far;

        far [distance >= 0];
    }
}
