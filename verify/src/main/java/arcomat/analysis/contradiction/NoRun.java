package arcomat.analysis.contradiction;

import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.model.Letter;
import arcomat.semantics.Promise;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Network.External;
import arcomat.semantics.network.Network.Instance;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Whether a component has no run at all after some inputs, since its automata contradict each
 * other. Then whatever is said of all its runs holds, and says nothing about a robot.
 */
public final class NoRun {
    private static final String REASON = "contradiction";

    private static final String ADAPTIVE = "after inputs that depend on its outputs";

    private static final String THERE = ", so it has no run there";

    private static final String IF_IT_COMES = "; %s has no run where these inputs come to it";

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
        if (verdict.answer() != Answer.HOLDS || isReasonOf(verdict)) {
            return verdict;
        }
        if (side.isComposition()) {
            return notedParts(side, verdict);
        }
        return found(side)
                .map(found -> verdict.because(REASON, note(side.title(), side, found) + THERE))
                .orElse(verdict);
    }

    /** A composition has no run where one of its parts has none. */
    private Verdict notedParts(Promise whole, Verdict verdict) {
        Network network = whole.network();
        Optional<String> note = Optional.empty();
        for (Instance part : network.instances()) {
            Promise side = Promise.of(part.component(), part.arguments());
            Optional<Consistency.Contradiction> found = found(side);
            if (found.isPresent()) {
                String text = note("part '" + part.path() + "'", side, found.get());
                if (comes(found.get(), part, network)) {
                    String certain = text + ", so " + whole.title() + " has no run there";
                    return verdict.because(REASON, certain);
                }
                note = note.or(() -> Optional.of(text + IF_IT_COMES.formatted(whole.title())));
            }
        }
        return note.filter(each -> !verdict.notes().contains(each))
                .map(verdict::with)
                .orElse(verdict);
    }

    /** Whether those who give a composition its inputs can bring a part there for certain. */
    private static boolean comes(Consistency.Contradiction found, Instance part, Network network) {
        Set<Integer> outside =
                network.inputs().stream().map(External::signal).collect(Collectors.toSet());
        Set<Integer> read = new HashSet<>(part.inputSignals());
        boolean each = read.size() == part.inputSignals().size() && outside.containsAll(read);
        return found.word().map(word -> word.isEmpty() || each).orElse(false);
    }

    private Optional<Consistency.Contradiction> found(Promise side) {
        return side.automata().size() < 2
                ? Optional.empty()
                : known.computeIfAbsent(side.title(), any -> Contradictions.first(side, budget));
    }

    /** Whether a verdict holds only where a component may have no run. */
    public static boolean isReasonOf(Verdict verdict) {
        return verdict.answer() == Answer.HOLDS && verdict.reason().equals(REASON);
    }

    /** What was noted of a verdict. */
    public static List<String> notes(Verdict verdict) {
        return verdict.notes().stream().filter(note -> note.startsWith(REASON + ": ")).toList();
    }

    private static String note(String named, Promise side, Consistency.Contradiction found) {
        String members =
                found.requirements().stream()
                        .map(each -> "'" + each.name() + "'")
                        .collect(Collectors.joining(", "));
        String title = named.equals(side.title()) ? named : side.title() + " in " + named;
        return "%s: automata %s of %s allow no output %s"
                .formatted(REASON, members, title, found.word().map(NoRun::after).orElse(ADAPTIVE));
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
