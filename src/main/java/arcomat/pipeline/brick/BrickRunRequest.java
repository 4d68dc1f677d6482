package arcomat.pipeline.brick;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * A program that is to run on a simulated brick.
 *
 * @param jar path of its jar
 * @param script path of a script that says what happens to the brick
 * @param seconds of virtual time at most; empty for as long as the script says
 */
public record BrickRunRequest(String jar, Optional<String> script, OptionalInt seconds) {}
