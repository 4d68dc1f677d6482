package fetcher;

import fetcher.Robot.*;

/** A press stops the robot, and it stands until the next one. */
component Stops {
    port
        in Distance front,
        in Boolean cup,
        in Button button,
        out MotorCmd cmd,
        out Lamp lamp;

    <<completion = "output", omitted = "free">> automaton {
        state going, standing;

        initial going / {cmd = ?};

        going -> standing {button == press} / {cmd = stop};
        standing {button == --} / {cmd = --};
        standing -> going {button == press} / {cmd = ?};
    }
}
