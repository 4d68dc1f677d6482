package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.Shortcut;

import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;

/**
 * Packed configurations give the same verdicts as those that are not. What only packed searches
 * leave out besides is in {@link LeftOutTest}.
 */
class PackedInclusionTest {
    private static final int QUESTIONS = Integer.getInteger("packed.questions", 300);
    private static final int SEED = Integer.getInteger("packed.seed", 19);

    /** Of rows that fail on the level on which they have more states than that. */
    private static final int AT_THE_LIMIT = 403;

    private static final Budget BUDGET = new Budget(() -> false, 3_000);

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

    private final Map<Answer, Integer> packed = new EnumMap<>(Answer.class);

    /** Of them, those that left out a pair beside one with a smaller set. */
    private int smaller;

    @Test
    void saysTheSameOfNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text(), Said::of);
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** Parts of one kind share the widths of their fields: those once did not fit the tables. */
    @Test
    void saysTheSameOfRows() {
        for (int i = 0; i < QUESTIONS / 4; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compareWhole(rows, "Any");
            compareWhole(rows, "Some");
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
    }

    /** Where the right side may be in several configurations at once. */
    @Test
    void saysTheSameAmongSets() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomRows rows = i % 3 == 0 ? RandomRows.equal(SEED + i) : new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString(), Said::of);
        }
        assertThat(packed.get(Answer.HOLDS)).isGreaterThan(QUESTIONS / 30);
        assertThat(packed.get(Answer.FAILS)).isGreaterThan(QUESTIONS / 30);
        assertThat(smaller).isGreaterThan(QUESTIONS / 30);
    }

    /** A failure that was found before the states were too many still counts. */
    @Test
    void saysTheSameAtTheLimit() {
        RandomRows rows = new RandomRows(AT_THE_LIMIT);
        compareWhole(rows, "Some");
        assertThat(packed).containsEntry(Answer.FAILS, 1);
    }

    /** The very same, texts and numbers: the right side is in one configuration at a time. */
    private void compareWhole(RandomRows rows, String right) {
        compare(rows.whole("Whole"), rows.whole(right), rows.toString(), Function.identity());
    }

    /**
     * @param compared what of a verdict has to be the same; all of it where that it holds comes
     *     from sets of one
     */
    private void compare(Promise left, Promise right, String text, Function<Verdict, ?> compared) {
        Set<Shortcut> taken = EnumSet.noneOf(Shortcut.class);
        Verdict quick = Refinement.compare(left, right, BUDGET.with(rule -> noted(rule, taken)));
        Verdict thorough =
                Refinement.compare(left, right, BUDGET.with(PackedInclusionTest::unpacked));
        assertThat((Object) compared.apply(quick)).as(text).isEqualTo(compared.apply(thorough));
        if (taken.contains(Shortcut.DETERMINED)) {
            assertThat(quick).as(text).isEqualTo(thorough);
        }
        if (taken.contains(Shortcut.PACKED)) {
            packed.merge(quick.answer(), 1, Integer::sum);
            smaller += taken.contains(Shortcut.MET_SMALLER) ? 1 : 0;
        }
    }

    private static boolean noted(Shortcut rule, Set<Shortcut> taken) {
        taken.add(rule);
        return !LeftOutTest.RULES.contains(rule) && rule != Shortcut.SIMULATED;
    }

    private static boolean unpacked(Shortcut rule) {
        return rule != Shortcut.PACKED && rule != Shortcut.SIMULATED;
    }
}
