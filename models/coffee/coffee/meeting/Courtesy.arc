package coffee.meeting;

import coffee.types.Types.*;

/**
 * What two fetchers owe each other, whoever watches both: the one with coffee, once it waits, goes
 * on only after the one without has begun to make room.
 */
component Courtesy {
    timing instant;

    port in MotorCmd empty, out MotorCmd loaded;

    <<completion = "chaos", omitted = "free">> automaton {
        state going, waiting, passing;

        initial going;

        going / {loaded = --};
        going / {loaded = fwd};
        going -> waiting / {loaded = stop};
        going -> passing {empty == backRight};

        waiting / {loaded = --};
        waiting / {loaded = stop};
        waiting -> passing {empty == backRight};
    }
}
