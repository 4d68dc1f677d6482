package arcomat.pipeline;

import arcomat.source.Diagnostic;
import arcomat.world.Recording;

import java.util.List;
import java.util.Optional;

/**
 * What came of running a world.
 *
 * @param findings about the world, and about the models of its robots
 * @param files how many were read
 * @param recording empty exactly if the findings did not let it run
 */
public record WorldResult(List<Diagnostic> findings, int files, Optional<Recording> recording) {
    public WorldResult {
        findings = List.copyOf(findings);
    }
}
