package ${packageName};

import ${packageName}.${component}Signals.*;

/**
 * What every pilot has to keep: it drives on only where nothing is within 20 cm; it may turn at any
 * time. How it decides is left open on purpose, so this is no program yet: ${component}Pilot is one.
 */
component ${component}Promise {
    timing instant;

    port
        /** In cm; 255 where nothing is seen. */
        <<total>> in Integer[0..255] distance,
        <<total>> out Move move;

    <<suppress = "ARC1001: when to turn is left open">> automaton {
        state going;

        initial going;

        going [distance > 20] / {move = forward};
        going / {move = turn};
    }
}
