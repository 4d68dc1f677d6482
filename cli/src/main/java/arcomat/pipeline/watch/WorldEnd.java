package arcomat.pipeline.watch;

import arcomat.source.Diagnostic;
import arcomat.world.Recording;

import java.util.List;
import java.util.Optional;

/**
 * How a world ended, with the first seed.
 *
 * @param world the file, as it is shown
 * @param recording empty where it could not run
 * @param findings about the world and its programs that are no findings about watched models
 * @param reason why it could not run, where no finding says so
 */
public record WorldEnd(
        String world,
        Optional<Recording> recording,
        List<Diagnostic> findings,
        Optional<String> reason) {
    public WorldEnd {
        findings = List.copyOf(findings);
    }

    /** As the command {@code world} judges. */
    public boolean succeeded() {
        return recording.isPresent() && recording.get().succeeded();
    }
}
