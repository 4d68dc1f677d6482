package coffee.parts;

import coffee.types.Types.*;

/**
 * Tells from a measured distance whether something is too close.
 *
 * near: tooClose up to here, in cm
 * far: clear from here on, in cm. Between the two nothing is said, so that a robot at the limit
 * does not jitter.
 */
component Proximity(Integer near, Integer far) {
    timing instant;

    port <<total>> in Integer[0..255] distance, out Distance front;

    <<completion = "ignore">> automaton {
        state watching;

        initial watching;

        watching [distance <= near] / {front = tooClose};
        watching [distance >= far && distance > near] / {front = clear};
    }
}
