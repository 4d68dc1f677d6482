package arcomat.pipeline.brick;

import arcomat.sim.Laboratory;

import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A program that is to run on a simulated brick.
 *
 * @param jar path of its jar
 * @param script path of a script that says what happens to the brick
 * @param seconds of virtual time at most; empty for as long as the script says
 * @param patience of the PC's time at most
 */
public record BrickRunRequest(
        String jar, Optional<String> script, OptionalInt seconds, Duration patience) {
    /** A request with the usual patience. */
    public BrickRunRequest(String jar, Optional<String> script, OptionalInt seconds) {
        this(jar, script, seconds, Laboratory.PATIENCE);
    }
}
