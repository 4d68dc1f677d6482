package coffee.parts;

/**
 * Tells bright from dark.
 *
 * limit: bright from here on, in percent
 */
component Brightness(Integer limit) {
    timing instant;

    port <<total>> in Integer value, <<total>> out Boolean bright;

    automaton {
        state watching;

        initial watching;

        watching / {bright = value >= limit};
    }
}
