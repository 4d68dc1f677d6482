package ${packageName};

import ${packageName}.${component}Signals.*;

/**
 * Says to each wheel how fast to turn, in degrees per second, and what the display shows.
 *
 * Try: one wheel that stands still while the robot turns.
 */
component ${component}Wheels {
    timing instant;

    port
        <<total>> in Move move,
        <<total>> out Integer left,
        <<total>> out Integer right,
        <<total>> out String doing;

    automaton {
        state rolling;

        initial rolling;

        rolling {move == forward} / {left = 360, right = 360, doing = "driving"};
        rolling {move == turn} / {left = 180, right = -180, doing = "turning"};
    }
}
