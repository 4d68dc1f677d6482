package mill;

/** Writes into books, which nobody reads here. */
component Desk {
    timing instant;
    port in Integer number, out Integer copy;
    <<completion = "ignore">> automaton {
        state Open;
        initial Open;
        Open -> Open / do {
            if (number != --) {
                copy = number;
            }
        };
    }
}
