package arcomat.analysis.search.encoding;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.search.Budget;
import arcomat.analysis.symbolic.Clauses;
import arcomat.analysis.symbolic.InductiveInvariant;
import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;
import arcomat.analysis.symbolic.TransitionRelation;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** An engine that errs proves nothing: what it finds is checked before it counts. */
class CheckedInvariantTest {
    /** Says at once that it has found what it was made with. */
    private record Claim(Optional<InductiveInvariant> invariant)
            implements InductiveInvariant.Search {
        @Override
        public Progress work(long amount) {
            return Progress.PROVED;
        }
    }

    @Test
    void whatIsNoInvariantIsNoProof() {
        assertThat(answer(Optional.empty())).as("nothing").isEqualTo(Progress.HOPELESS);
        assertThat(answer(excluding())).as("a bad step is left").isEqualTo(Progress.HOPELESS);
        assertThat(answer(excluding(1, 3))).as("runs begin there").isEqualTo(Progress.HOPELESS);
        assertThat(answer(excluding(2, 3))).as("steps lead there").isEqualTo(Progress.HOPELESS);
    }

    @Test
    void whatIsOneIs() {
        assertThat(answer(excluding(3))).isEqualTo(Progress.PROVED);
    }

    @Test
    void whatTwoAreCalledHasNoMeaning() {
        StateWords.Collector collector = new StateWords.Collector();
        collector.each(List.of("x: s", "y: s", "y: s"));
        StateWords words = collector.words(List.of());
        assertThat(words.literal("x: s")).hasValue(1);
        assertThat(words.literal("not x: s")).hasValue(-1);
        assertThat(words.literal("y: s")).isEmpty();
        assertThat(words.literal("not y: s")).isEmpty();
    }

    /** That none of some lamps is ever on. */
    private static Optional<InductiveInvariant> excluding(int... lamps) {
        return Optional.of(
                new InductiveInvariant(
                        IntStream.of(lamps).mapToObj(lamp -> new int[] {lamp}).toList()));
    }

    private static Progress answer(Optional<InductiveInvariant> found) {
        Budget budget = new Budget(() -> false, 1_000);
        return new SymbolicInclusion(named(), new Claim(found), budget).work(1);
    }

    private static InclusionBits named() {
        StateWords.Collector words = new StateWords.Collector();
        words.each(List.of("first", "second", "third"));
        return new InclusionBits(lamps(), () -> words.words(List.of()), List.of());
    }

    /** The first two lamps change places; a step is bad where the third one is on: it never is. */
    private static TransitionRelation lamps() {
        Clauses clauses = new Clauses();
        int[] lamps = {clauses.variable(), clauses.variable(), clauses.variable()};
        return new TransitionRelation(
                clauses,
                lamps,
                new int[] {lamps[1], lamps[0], lamps[2]},
                new boolean[lamps.length],
                new int[0],
                clauses.truth(),
                lamps[2],
                List.of(new boolean[] {true, false, false}));
    }
}
