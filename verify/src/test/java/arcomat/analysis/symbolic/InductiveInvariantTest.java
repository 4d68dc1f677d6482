package arcomat.analysis.symbolic;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.symbolic.PropertyDirectedReachability.Progress;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;

/** A ring in which a token goes round: never are there two. */
class InductiveInvariantTest {
    private static final int PLACES = 6;

    @Test
    void isFoundAndProves() {
        TransitionRelation ring = ring(new boolean[] {true});
        InductiveInvariant found = found(ring);
        assertThat(found.excluded()).isNotEmpty();
        assertThat(found.proves(ring, () -> {})).isTrue();
    }

    @Test
    void isNotFoundWhereABadStepIsPossible() {
        TransitionRelation ring = ring(new boolean[] {true, false, true});
        PropertyDirectedReachability search = new PropertyDirectedReachability(ring, () -> {});
        assertThat(search.work(Long.MAX_VALUE / 2)).isEqualTo(Progress.HOPELESS);
        assertThat(search.invariant()).isEmpty();
    }

    /** Without one of its cubes, with one that is too large, with one in which a run begins. */
    @Test
    void provesNothingWhereItIsWrong() {
        TransitionRelation ring = ring(new boolean[] {true});
        List<int[]> excluded = found(ring).excluded();
        for (int i = 0; i < excluded.size(); i++) {
            List<int[]> fewer = new ArrayList<>(excluded);
            fewer.remove(i);
            assertThat(proves(ring, fewer)).as("without cube " + i).isFalse();
        }
        List<int[]> more = new ArrayList<>(excluded);
        more.add(new int[] {PLACES});
        assertThat(proves(ring, more)).as("with a state that is reached").isFalse();
        more.set(excluded.size(), new int[] {1});
        assertThat(proves(ring, more)).as("with a beginning").isFalse();
    }

    /** What excludes nothing proves nothing, nor does what is about another system. */
    @Test
    void provesNothingElse() {
        List<int[]> excluded = found(ring(new boolean[] {true})).excluded();
        assertThat(proves(ring(new boolean[] {true}), List.of())).isFalse();
        assertThat(proves(ring(new boolean[] {true, true}), excluded)).isFalse();
    }

    private static boolean proves(TransitionRelation relation, List<int[]> excluded) {
        return new InductiveInvariant(excluded).proves(relation, () -> {});
    }

    private static InductiveInvariant found(TransitionRelation relation) {
        PropertyDirectedReachability search = new PropertyDirectedReachability(relation, () -> {});
        assertThat(search.work(Long.MAX_VALUE / 2)).isEqualTo(Progress.PROVED);
        return search.invariant().orElseThrow();
    }

    /**
     * All tokens stay, or all go to the next place; a step is bad where two neighbours have one.
     *
     * @param tokens in the first places
     */
    private static TransitionRelation ring(boolean[] tokens) {
        Clauses clauses = new Clauses();
        int[] state = new int[PLACES];
        int[] next = new int[PLACES];
        for (int place = 0; place < PLACES; place++) {
            state[place] = clauses.variable();
            next[place] = clauses.variable();
        }
        int moves = clauses.variable();
        int[] neighbours = new int[PLACES];
        for (int place = 0; place < PLACES; place++) {
            int from = state[(place + PLACES - 1) % PLACES];
            for (int sign = -1; sign <= 1; sign += 2) {
                clauses.add(-moves, -sign * from, sign * next[place]);
                clauses.add(moves, -sign * state[place], sign * next[place]);
            }
            neighbours[place] = clauses.and(state[place], from);
        }
        boolean[] initial = new boolean[PLACES];
        System.arraycopy(tokens, 0, initial, 0, tokens.length);
        int bad = tokens.length == 3 ? clauses.and(state[3], state[5]) : clauses.or(neighbours);
        return new TransitionRelation(
                clauses,
                state,
                next,
                new boolean[PLACES],
                new int[] {moves},
                clauses.truth(),
                bad,
                List.of(initial));
    }
}
