package arcomat.analysis.evolution;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What became of a component.
 *
 * @param witnesses what shows it: first why it does not keep what it promised, then why the old one
 *     did not keep what the new one promises; empty where nothing is to be shown
 * @param reason why it is unknown; else empty
 */
public record Change(Relation relation, List<Witness> witnesses, String reason) {
    public static final Change UNCHANGED = plain(Relation.UNCHANGED);
    public static final Change NEW = plain(Relation.NEW);
    public static final Change GONE = plain(Relation.GONE);
    public static final Change UNREAD = plain(Relation.UNREAD);

    public Change {
        witnesses = List.copyOf(witnesses);
    }

    /** From the new version to the old one. */
    public enum Relation {
        /** Says what it said. */
        UNCHANGED,
        /** Says it in another way. */
        EQUIVALENT,
        /** Promises more. */
        REFINES,
        /** Promises less. */
        WIDENS,
        /** Promises more in one place and less in another. */
        INCOMPARABLE,
        NEW,
        GONE,
        UNKNOWN,
        /** Nobody can tell before a file that could not be read is mended. */
        UNREAD;

        /** Whether what was promised is not kept. */
        public boolean breaks() {
            return this == WIDENS || this == INCOMPARABLE || this == GONE;
        }

        /** Whether what was promised is not kept, or not known to be. */
        public boolean isDoubtful() {
            return breaks() || this == UNKNOWN || this == UNREAD;
        }
    }

    /**
     * Why one version does not keep what the other one promises.
     *
     * @param left what does not keep it
     * @param right what promises
     */
    public record Witness(String left, String right, Verdict verdict) {}

    public static Change unknown(String reason) {
        return new Change(Relation.UNKNOWN, List.of(), reason);
    }

    private static Change plain(Relation relation) {
        return new Change(relation, List.of(), "");
    }

    /**
     * By comparisons in both directions. Whether the new version keeps the promises decides; where
     * only the way back is unknown, the new one is taken to promise more.
     */
    static Change of(List<Witness> forward, List<Witness> backward) {
        Optional<Witness> kept = decisive(forward);
        Optional<Witness> back = decisive(backward);
        if (kept.isPresent() && kept.get().verdict().answer() == Answer.UNKNOWN) {
            return unknown(kept.get().verdict().reason());
        }
        boolean backHolds = !backward.isEmpty() && back.isEmpty();
        Relation relation =
                kept.isEmpty()
                        ? backHolds ? Relation.EQUIVALENT : Relation.REFINES
                        : backHolds ? Relation.WIDENS : Relation.INCOMPARABLE;
        List<Witness> witnesses = Stream.concat(kept.stream(), back.stream()).toList();
        return new Change(relation, witnesses, "");
    }

    /** The first that fails, else the first that is unknown; empty where all hold. */
    private static Optional<Witness> decisive(List<Witness> all) {
        return first(all, Answer.FAILS).or(() -> first(all, Answer.UNKNOWN));
    }

    private static Optional<Witness> first(List<Witness> all, Answer answer) {
        return all.stream().filter(each -> each.verdict().answer() == answer).findFirst();
    }
}
