package arcomat.analysis.search.packed;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.refinement.ComparedSystems;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.product.TraceInclusion;
import arcomat.semantics.Promise;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * Asks questions with packed configurations and with others, and counts. Simulations are asked
 * neither here nor there, and nothing is left out but pairs.
 */
public final class PackedComparison {
    /** What is left out beyond pairs. */
    public static final Set<Shortcut> LEFT_OUT =
            Set.of(Shortcut.CONE, Shortcut.UNREAD_VARIABLES, Shortcut.EQUAL_PARTS);

    /**
     * A verdict where the right side may be in several configurations at once: without their order,
     * and without numbers of configurations. Unpacked, it is asked whether a member of a set
     * simulates a configuration. That meets more of them, also where the answer is not made use of.
     */
    private record Said(
            Answer answer,
            String reason,
            Optional<Boolean> simulation,
            List<List<Object>> trace,
            Set<Sentence> explanation,
            List<String> notes,
            long pairs) {
        static Said of(Verdict verdict) {
            return new Said(
                    verdict.answer(),
                    verdict.reason(),
                    verdict.simulation(),
                    verdict.trace().stream().map(Said::of).toList(),
                    Set.copyOf(verdict.explanation()),
                    verdict.notes(),
                    verdict.explored().pairs());
        }

        private static List<Object> of(Moment moment) {
            return List.of(
                    moment.input(),
                    moment.outputs(),
                    moment.left(),
                    Set.copyOf(moment.right()),
                    moment.error());
        }
    }

    private final Budget budget;
    private final Map<Answer, Integer> packed = new EnumMap<>(Answer.class);
    private int smaller;

    /**
     * @param states so many are explored
     */
    public PackedComparison(int states) {
        budget = new Budget(() -> false, states);
    }

    /** How many packed searches have come to an answer. */
    public int packed(Answer answer) {
        return packed.getOrDefault(answer, 0);
    }

    /** How many packed searches left out a pair beside one with a smaller set. */
    public int smaller() {
        return smaller;
    }

    /**
     * The right side may be in several configurations at once.
     *
     * @return whether configurations were packed
     */
    public boolean compare(Promise left, Promise right, String text) {
        return compare(left, right, text, Said::of);
    }

    /** The very same, texts and numbers: the right side is in one configuration at a time. */
    public boolean compareWhole(Promise left, Promise right, String text) {
        return compare(left, right, text, Function.identity());
    }

    /**
     * @param compared what of a verdict has to be the same; all of it where that it holds comes
     *     from sets of one
     */
    private boolean compare(
            Promise left, Promise right, String text, Function<Verdict, ?> compared) {
        Set<Shortcut> taken = EnumSet.noneOf(Shortcut.class);
        Verdict quick = Refinement.compare(left, right, budget.with(rule -> noted(rule, taken)));
        Verdict thorough = Refinement.compare(left, right, budget.with(PackedComparison::unpacked));
        assertThat((Object) compared.apply(quick)).as(text).isEqualTo(compared.apply(thorough));
        if (taken.contains(Shortcut.DETERMINED)) {
            assertThat(quick).as(text).isEqualTo(thorough);
        }
        boolean isPacked = isPacked(left, right);
        if (isPacked) {
            packed.merge(quick.answer(), 1, Integer::sum);
            smaller += taken.contains(Shortcut.MET_SMALLER) ? 1 : 0;
        }
        return isPacked;
    }

    /** Only pairs that are not packed can be told as a certificate. */
    private boolean isPacked(Promise left, Promise right) {
        TraceInclusion inclusion = ComparedSystems.of(left, right, budget).inclusion(budget);
        inclusion.run();
        return inclusion.certificate().isEmpty();
    }

    private static boolean noted(Shortcut rule, Set<Shortcut> taken) {
        taken.add(rule);
        return !LEFT_OUT.contains(rule) && rule != Shortcut.SIMULATED;
    }

    private static boolean unpacked(Shortcut rule) {
        return rule != Shortcut.PACKED && rule != Shortcut.SIMULATED;
    }
}
