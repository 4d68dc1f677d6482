package arcomat.pipeline;

import java.util.Optional;

/**
 * A world that is to run.
 *
 * @param world path of its text
 * @param seed of everything that is drawn
 * @param report folder for the recording
 */
public record WorldRequest(String world, long seed, Optional<String> report) {}
