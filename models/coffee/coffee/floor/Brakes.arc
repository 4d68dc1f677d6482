package coffee.floor;

import coffee.types.Types.*;

/** What any drive promises: told to stop, both wheels stop at once. */
component Brakes {
    timing instant;

    port
        in MotorCmd cmd,
        /** In degrees per second. */
        out Integer leftSpeed,
        /** In degrees per second. */
        out Integer rightSpeed;

    <<completion = "output">> automaton {
        state any;

        initial any;

        any {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
    }
}
