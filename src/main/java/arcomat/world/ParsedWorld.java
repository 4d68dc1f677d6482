package arcomat.world;

import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/**
 * A world that was read.
 *
 * @param world absent if there are findings
 * @param findings in the order of the text
 */
public record ParsedWorld(Optional<World> world, List<Diagnostic> findings) {
    public ParsedWorld {
        findings = List.copyOf(findings);
    }
}
