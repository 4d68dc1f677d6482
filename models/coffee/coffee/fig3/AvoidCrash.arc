package coffee.fig3;

import coffee.types.Types.*;

/**
 * Keeps a fetcher from running into another one: the first requirement (the paper, Fig. 3).
 *
 * Whether a robot that comes too close makes room or waits is left open on purpose: both
 * transitions of driving are allowed. What is not drawn is open as well, hence chaos.
 */
component AvoidCrash {
    port in Distance frontUS, out MotorCmd cmd;

    <<completion = "chaos">> automaton {
        state driving, sidestep, waiting;

        initial driving / {cmd = fwd};

        driving -> sidestep {frontUS == tooClose} / {cmd = backRight};
        driving -> waiting {frontUS == tooClose} / {cmd = stop};
        waiting -> driving {frontUS == clear} / {cmd = fwd};
    }
}
