package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.List;

/**
 * The result of checking.
 *
 * @param findings ordered by {@link Diagnostic#ORDER}, each once
 * @param suppressed what a {@code <<suppress>>} declares to be meant, in the same order
 */
public record Review(List<Diagnostic> findings, List<Suppressed> suppressed) {
    public Review {
        findings = List.copyOf(findings);
        suppressed = List.copyOf(suppressed);
    }
}
