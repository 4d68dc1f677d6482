package yard;

/** What is small stays small. */
component Small {
    timing instant;

    port in Integer[0..100] value;

    <<completion = "error">> automaton {
        state small;

        initial small;

        small [value <= 100];
        small {value == --};
    }
}
