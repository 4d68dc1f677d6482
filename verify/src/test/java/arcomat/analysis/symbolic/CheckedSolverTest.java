package arcomat.analysis.symbolic;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.semantics.value.GivenUp;

import org.junit.jupiter.api.Test;

import java.util.Arrays;

/** Pigeons that come one by one, each into a hole of its own. */
class CheckedSolverTest {
    private static final int HOLES = 7;

    private final CheckedSolver solver = new CheckedSolver(() -> {});

    @Test
    void clausesMayComeBetweenQuestions() {
        int[][] pigeons = new int[HOLES + 1][];
        for (int i = 0; i <= HOLES; i++) {
            pigeons[i] = comes(Arrays.copyOf(pigeons, i));
            assertThat(solver.solve()).as("%d pigeons", i + 1).isEqualTo(i < HOLES);
        }
        assertThat(solver.solve()).as("asked again").isFalse();
    }

    /** What cannot be together with something can be without it. */
    @Test
    void literalsHoldForOneQuestion() {
        int[] first = comes(new int[0][]);
        int[] second = comes(new int[][] {first});
        assertThat(solver.solveWith(first[2], second[2])).isFalse();
        assertThat(solver.solveWith(first[2], second[1])).isTrue();
        assertThat(solver.isTrue(first[2])).isTrue();
        assertThat(solver.isTrue(-second[2])).isTrue();
        assertThat(solver.solve()).isTrue();
    }

    @Test
    void anAnswerTakesNoMoreWorkThanItMay() {
        int[] first = comes(new int[0][]);
        int[] second = comes(new int[][] {first});
        assertThat(solver.answer(1_000, first[2], second[2])).contains(false);
        assertThat(solver.answer(1_000, first[2], second[1])).contains(true);
        int[][] pigeons = {first, second};
        while (pigeons.length <= HOLES) {
            pigeons = Arrays.copyOf(pigeons, pigeons.length + 1);
            pigeons[pigeons.length - 1] = comes(Arrays.copyOf(pigeons, pigeons.length - 1));
        }
        assertThat(solver.answer(0)).as("in no time").isEmpty();
        assertThat(solver.answer(100_000_000)).contains(false);
    }

    @Test
    void givesUpWhenItIsToldTo() {
        CheckedSolver hurried =
                new CheckedSolver(
                        () -> {
                            throw new GivenUp("no time");
                        });
        int one = hurried.clauses().variable();
        hurried.clauses().add(one);
        hurried.clauses().add(-one);
        assertThatThrownBy(hurried::solve).isInstanceOf(GivenUp.class);
    }

    /** Into a hole of its own, which none of those before it is in. */
    private int[] comes(int[][] before) {
        int[] holes = solver.clauses().oneOf(HOLES);
        for (int[] other : before) {
            for (int hole = 0; hole < HOLES; hole++) {
                solver.clauses().add(-holes[hole], -other[hole]);
            }
        }
        return holes;
    }
}
