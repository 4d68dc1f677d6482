package arcomat.analysis.refinement;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomNetworks;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.encoding.SymbolicInclusion;
import arcomat.analysis.search.system.NetworkSystem;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;
import arcomat.semantics.Promise;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;

/** The symbolic engine proves nothing that fails, and most of what holds and is for it. */
class SymbolicInclusionTest {
    private static final int QUESTIONS = Integer.getInteger("symbolic.questions", 200);
    private static final int SEED = Integer.getInteger("symbolic.seed", 31);
    private static final long WORK = 20_000_000;
    private static final Budget BUDGET = new Budget(() -> false, 20_000);

    /** By what an explicit search says, what the symbolic one says. */
    private final Map<Answer, Map<Progress, Integer>> seen = new EnumMap<>(Answer.class);

    @Tag("slow")
    @Test
    void provesNothingThatFailsInNetworks() {
        RandomNetworks networks = new RandomNetworks(SEED);
        for (int i = 0; i < QUESTIONS; i++) {
            RandomNetworks.Question question = networks.question();
            compare(question.left(), question.right(), question.text());
        }
        assertThat(count(Answer.HOLDS, Progress.PROVED)).isGreaterThan(QUESTIONS / 20);
        assertThat(count(Answer.FAILS, Progress.HOPELESS)).isGreaterThan(QUESTIONS / 40);
    }

    /** Nothing is left open there, so that it proves all that holds. */
    @Tag("slow")
    @Test
    void decidesRows() {
        for (int i = 0; i < QUESTIONS; i++) {
            RandomRows rows = new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        assertDecides();
    }

    @Tag("slow")
    @Test
    void decidesEqualParts() {
        for (int i = 0; i < QUESTIONS / 2; i++) {
            RandomRows rows = RandomRows.equal(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Any"), rows.toString());
            compare(rows.whole("Whole"), rows.whole("Some"), rows.toString());
        }
        assertDecides();
    }

    /** Where the right side may be in several configurations at once. */
    @Tag("slow")
    @Test
    void decidesAmongSets() {
        for (int i = 0; i < 2 * QUESTIONS; i++) {
            RandomRows rows = i % 3 == 0 ? RandomRows.equal(SEED + i) : new RandomRows(SEED + i);
            compare(rows.whole("Whole"), rows.whole("Several"), rows.toString());
        }
        assertDecides();
    }

    private void assertDecides() {
        assertThat(count(Answer.HOLDS, Progress.PROVED)).isGreaterThan(QUESTIONS / 10);
        assertThat(count(Answer.FAILS, Progress.HOPELESS)).isGreaterThan(QUESTIONS / 10);
        assertThat(count(Answer.HOLDS, Progress.HOPELESS)).isZero();
    }

    private int count(Answer answer, Progress progress) {
        return seen.getOrDefault(answer, Map.of()).getOrDefault(progress, 0);
    }

    private void compare(Promise left, Promise right, String text) {
        Optional<SymbolicInclusion> engine = engine(ComparedSystems.of(left, right, BUDGET));
        if (engine.isEmpty()) {
            return;
        }
        Progress progress = engine.get().work(WORK);
        Answer answer = Refinement.compare(left, right, BUDGET).answer();
        assertThat(answer == Answer.FAILS && progress == Progress.PROVED).as(text).isFalse();
        seen.computeIfAbsent(answer, each -> new EnumMap<>(Progress.class))
                .merge(progress, 1, Integer::sum);
    }

    private static Optional<SymbolicInclusion> engine(ComparedSystems systems) {
        return systems.left() instanceof NetworkSystem network && network.canBePacked()
                ? SymbolicInclusion.of(network, systems.right(), systems.outputs(), BUDGET)
                : Optional.empty();
    }
}
