package yard;

/** Two things are never so at the same time. */
component Exclusive {
    timing instant;

    port <<total>> in Boolean left, <<total>> in Boolean right;

    <<completion = "error">> automaton {
        state free;

        initial free;

        free [!left || !right];
    }
}
