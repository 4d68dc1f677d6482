/** Three states are left for the same one in the same way: they share an arrow, and what it says. */
component Turnstile {
    port in Boolean coin, in Boolean kick, out Integer open;

    automaton {
        state closed, ajar, wide;
        initial closed;
        closed -> ajar [coin] / {open = 1};
        ajar -> wide [coin] / {open = 2};
        ajar -> closed [kick] / {open = 0};
        wide -> closed [kick] / {open = 0};
        wide [coin] / {open = 2};
    }
}
