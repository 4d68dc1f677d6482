package ${packageName};

import ${packageName}.${component}Signals.*;

/**
 * Drives until something is near, and turns until the way is clear.
 *
 * Try: write 10 instead of 30 below, and ask 'arcomat verify'. It shows how the promise is broken.
 */
component ${component}Pilot refines ${component}Promise {
    timing instant;

    port
        /** In cm; 255 where nothing is seen. */
        <<total>> in Integer[0..255] distance,
        <<total>> out Move move;

    automaton {
        state turning, driving;

        initial turning;

        turning [distance <= 60] / {move = turn};
        turning -> driving [distance > 60] / {move = forward};

        driving [distance > 30] / {move = forward};
        driving -> turning [distance <= 30] / {move = turn};
    }
}
