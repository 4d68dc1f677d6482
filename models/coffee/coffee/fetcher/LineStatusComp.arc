package coffee.fetcher;

import coffee.types.Types.*;

/**
 * Tells from the two light sensors where the line is. The line is dark and as wide as the
 * sensors are apart: both see it while the robot is on course, one of them when it has drifted,
 * none when the line is lost.
 *
 * dark: the line is darker than this, in percent
 */
component LineStatusComp(Integer dark) {
    timing instant;

    port
        <<total>> in Integer leftLight,
        <<total>> in Integer rightLight,
        <<total>> out LineStatus ls,
        <<total>> out Drift drift;

    automaton {
        state watching;

        initial watching;

        watching [leftLight < dark && rightLight < dark] / {ls = ok, drift = none};
        watching [leftLight >= dark && rightLight < dark] / {ls = ok, drift = left};
        watching [leftLight < dark && rightLight >= dark] / {ls = ok, drift = right};
        watching [leftLight >= dark && rightLight >= dark] / {ls = lost, drift = none};
    }
}
