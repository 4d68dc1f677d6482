package coffee.fetcher;

import coffee.types.Types.*;

/**
 * Drives two wheels as told and follows the line while it goes forward: where the robot has
 * drifted to one side, the wheel on the other side slows down. Off the line it goes straight.
 */
component Drive {
    timing instant;

    port
        in MotorCmd cmd,
        <<total>> in Drift drift,
        /** In degrees per second. */
        out Integer leftSpeed,
        /** In degrees per second. */
        out Integer rightSpeed;

    /** Straight on, in degrees per second. */
    Integer cruise = 360;

    /** The inner wheel in a bend, in degrees per second. */
    Integer slow = 120;

    <<completion = "ignore">> automaton {
        state standing, following, backing;

        initial standing;

        standing -> following {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
        standing -> backing {cmd == backRight} / {leftSpeed = -cruise, rightSpeed = -slow};

        following {cmd == --, drift == none} / {leftSpeed = cruise, rightSpeed = cruise};
        following {cmd == --, drift == left} / {leftSpeed = cruise, rightSpeed = slow};
        following {cmd == --, drift == right} / {leftSpeed = slow, rightSpeed = cruise};
        following -> standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        // The left wheel runs back faster: the tail swings to the right, the nose back to the line.
        following -> backing {cmd == backRight} / {leftSpeed = -cruise, rightSpeed = -slow};

        backing -> standing {cmd == stop} / {leftSpeed = 0, rightSpeed = 0};
        backing -> following {cmd == fwd} / {leftSpeed = cruise, rightSpeed = cruise};
    }
}
