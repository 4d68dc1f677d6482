package arcomat.analysis.automaton;

import arcomat.analysis.search.Moment;
import arcomat.model.Letter;
import arcomat.source.Diagnostic;

import java.util.List;
import java.util.Optional;

/**
 * Something about one automaton that its author should know.
 *
 * @param diagnostic code, places and words
 * @param trace a shortest run to where it is seen, the initial outputs first; empty where the
 *     finding is that something never happens
 * @param witness what is read then, where the finding is about a letter
 */
public record Finding(Diagnostic diagnostic, List<Moment> trace, Optional<Letter> witness) {
    public Finding {
        trace = List.copyOf(trace);
    }

    /** That something never happens. */
    static Finding never(Diagnostic diagnostic) {
        return new Finding(diagnostic, List.of(), Optional.empty());
    }

    public String code() {
        return diagnostic.code();
    }
}
