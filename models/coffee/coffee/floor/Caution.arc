package coffee.floor;

import coffee.types.Types.*;

/**
 * What may lie between eyes and a decision: danger is passed on at once; that all is clear may be
 * told late or not at all, but never where it is not.
 */
component Caution {
    timing instant;

    port in Distance seen, out Distance front;

    <<completion = "ignore", suppress = "ARC1001: that all is clear may be told late">> automaton {
        state watching;

        initial watching;

        watching {seen == tooClose} / {front = tooClose};
        watching {seen == clear} / {front = clear};
        watching {seen == clear};
    }
}
