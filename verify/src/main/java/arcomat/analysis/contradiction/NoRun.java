package arcomat.analysis.contradiction;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Letter;
import arcomat.semantics.Promise;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Whether a component has no run at all after some inputs, since its automata contradict each
 * other. Then whatever is said of all its runs holds, and says nothing about a robot.
 */
public final class NoRun {
    private static final String REASON = "contradiction";

    private static final String ADAPTIVE = "after inputs that depend on its outputs";

    /** More inputs than these are counted, not shown. */
    private static final int MOST_SHOWN = 4;

    private final Budget budget;
    private final Map<String, Optional<Consistency.Contradiction>> known = new HashMap<>();

    /**
     * About components of one model: of each, the search is made once, however often it is asked.
     *
     * @param budget where it ends a search, nothing is said
     */
    public NoRun(Budget budget) {
        this.budget = budget;
    }

    /** A verdict about all runs of a component, which says so where inputs leave it none. */
    public Verdict noted(Promise side, Verdict verdict) {
        if (verdict.answer() != Answer.HOLDS || side.automata().size() < 2) {
            return verdict;
        }
        return known.computeIfAbsent(side.title(), any -> Contradictions.first(side, budget))
                .map(found -> verdict.because(REASON, note(side, found)))
                .orElse(verdict);
    }

    /** Whether a verdict holds only where a component may have no run. */
    public static boolean isReasonOf(Verdict verdict) {
        return verdict.answer() == Answer.HOLDS && verdict.reason().equals(REASON);
    }

    private static String note(Promise side, Consistency.Contradiction found) {
        String members =
                found.requirements().stream()
                        .map(each -> "'" + each.name() + "'")
                        .collect(Collectors.joining(", "));
        return "contradiction: automata %s of %s allow no output %s, so it has no run there"
                .formatted(members, side.title(), found.word().map(NoRun::after).orElse(ADAPTIVE));
    }

    private static String after(List<Letter> word) {
        if (word.isEmpty()) {
            return "at the beginning";
        }
        String shown =
                word.stream()
                        .skip(Math.max(0, word.size() - MOST_SHOWN))
                        .map(NoRun::text)
                        .collect(Collectors.joining("; "));
        int others = word.size() - MOST_SHOWN;
        return others > 0
                ? "after %d inputs, the last of which are %s".formatted(word.size(), shown)
                : "after " + shown;
    }

    private static String text(Letter letter) {
        return letter.isSilent()
                ? "--"
                : letter.messages().entrySet().stream()
                        .map(each -> each.getKey() + " = " + values(each.getValue()))
                        .collect(Collectors.joining(", "));
    }

    private static String values(List<?> values) {
        return values.stream().map(Object::toString).collect(Collectors.joining(", "));
    }
}
