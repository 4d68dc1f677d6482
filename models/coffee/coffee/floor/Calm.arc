package coffee.floor;

import coffee.types.Types.*;

/**
 * Believes that the way is clear only when it has been so for a while. Another robot that makes
 * room leaves the sight before it is out of the way.
 */
component Calm refines Caution {
    timing instant;

    port in Distance seen, out Distance front;

    /** Slices in which it has to be clear without a break: two seconds. */
    Integer patience = 20;

    <<completion = "ignore">> automaton {
        state watching;

        /** Slices in which it was clear, without a break. */
        variable Integer[0..20] quiet = 0;

        initial watching;

        watching {seen == tooClose} / {front = tooClose, quiet = 0};
        watching {seen == --} / {quiet = 0};
        watching [quiet + 1 < patience] {seen == clear} / {quiet = quiet + 1};
        watching [quiet + 1 >= patience] {seen == clear} / {front = clear};
    }
}
