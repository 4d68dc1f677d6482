package arcomat.check;

import arcomat.source.Diagnostic;
import arcomat.source.Suppressed;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;

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

    /** What both found. */
    public Review and(Review more) {
        if (more.findings.isEmpty() && more.suppressed.isEmpty()) {
            return this;
        }
        TreeSet<Diagnostic> all = new TreeSet<>(Diagnostic.ORDER);
        all.addAll(findings);
        all.addAll(more.findings);
        List<Suppressed> meant = new ArrayList<>(suppressed);
        meant.addAll(more.suppressed);
        meant.sort(Comparator.comparing(Suppressed::finding, Diagnostic.ORDER));
        return new Review(List.copyOf(all), meant);
    }
}
