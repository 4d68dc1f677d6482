package arcomat.model;

import arcomat.model.Automaton.Transition;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * That a transition out of the present state was not enabled, and why.
 *
 * @param index position in {@link Automaton#transitions}
 * @param arrow where it would have led, {@code moving -> stopped}
 * @param clauses all that it asks, in the order of the text; one of them at least is not true
 */
public record Refusal(int index, Transition transition, String arrow, List<Clause> clauses) {
    /** More than these say no more to a reader of one line. */
    private static final int MOST_REASONS = 3;

    public Refusal {
        clauses = List.copyOf(clauses);
    }

    /** What became of a clause. */
    public enum Truth {
        TRUE,
        FALSE,
        /** A port that it reads carries no message. */
        UNDEFINED,
        /** It cannot be computed: a division by zero. */
        WRONG
    }

    /**
     * A condition that has to be true besides the others.
     *
     * @param text as models write it
     * @param effect whether it is what outputs and assignments read that has to be there
     * @param because what made it so: the values that it has read, the ports that were silent;
     *     empty where it is true
     */
    public record Clause(String text, boolean effect, Truth truth, String because) {}

    /** The clauses that are not true; each of them alone would have been enough. */
    public List<Clause> failed() {
        return clauses.stream().filter(each -> each.truth != Truth.TRUE).toList();
    }

    /** Those that have failed, by their reason: one silent port may fail several. */
    private Map<String, List<Clause>> byReason() {
        return failed().stream()
                .collect(
                        Collectors.groupingBy(
                                Clause::because, LinkedHashMap::new, Collectors.toList()));
    }

    /**
     * That with the fewest failed clauses, of which those with one reason count as one; of equally
     * near ones the first in the text.
     */
    public static Optional<Refusal> nearest(List<Refusal> refusals) {
        return refusals.stream().min(Comparator.comparingInt(each -> each.byReason().size()));
    }

    /** {@code moving -> stopped (line 14) did not fire: distance < 20: distance is silent}. */
    public String words() {
        Map<String, List<Clause>> reasons = byReason();
        int more = reasons.size() - MOST_REASONS;
        return "%s (line %d) did not fire: %s%s"
                .formatted(
                        arrow,
                        transition.span().startPosition().line(),
                        reasons.entrySet().stream()
                                .limit(MOST_REASONS)
                                .map(each -> texts(each.getValue()) + ": " + each.getKey())
                                .collect(Collectors.joining("; ")),
                        more > 0 ? "; and " + more + " more" : "");
    }

    /** What an effect reads goes without saying where a condition has asked for it. */
    private static String texts(List<Clause> alike) {
        boolean effects = alike.stream().allMatch(Clause::effect);
        return alike.stream()
                .filter(each -> effects || !each.effect)
                .map(Clause::text)
                .collect(Collectors.joining(", "));
    }
}
