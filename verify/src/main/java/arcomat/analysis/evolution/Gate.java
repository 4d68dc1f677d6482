package arcomat.analysis.evolution;

import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/** What became of every component of a model, by their names. */
public record Gate(List<Entry> entries) {
    public Gate {
        entries = List.copyOf(entries);
    }

    /**
     * What became of one component.
     *
     * @param old where it was; empty for a new one
     * @param fresh where it is; empty for one that is gone
     * @param excuse the reason that the model gives for a promise that is not kept, or not known to
     *     be kept; empty where there is none, and where none is needed
     * @param cause the part, or part of a part, that changed and to which this is owed; empty where
     *     a component has itself to thank
     */
    public record Entry(
            String name,
            Change change,
            Optional<Span> old,
            Optional<Span> fresh,
            Optional<String> excuse,
            Optional<String> cause) {

        /** The same, owed to a part. */
        public Entry owedTo(Entry part) {
            String origin = part.cause().orElse(part.name());
            return new Entry(name, change, old, fresh, part.excuse(), Optional.of(origin));
        }

        /** Fails where a promise is not kept and nobody says why. */
        public Answer answer() {
            if (excuse.isPresent() || !change.relation().isDoubtful()) {
                return Answer.HOLDS;
            }
            return change.relation().breaks() ? Answer.FAILS : Answer.UNKNOWN;
        }
    }

    /** Fails if one does, is unknown if one is, else holds. */
    public Answer answer() {
        return entries.stream().map(Entry::answer).reduce(Answer.HOLDS, Answer::and);
    }
}
