package arcomat.analysis.smt;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.reachability.Logic.Answer;

import de.uni_freiburg.informatik.ultimate.logic.Term;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BooleanSupplier;

/** Whether some numbers of a few can all be different: what it has to search for. */
class SolverTest {
    @Test
    void answers() {
        assertThat(canDiffer(5, 4, () -> false)).isEqualTo(Answer.NO);
        assertThat(canDiffer(4, 4, () -> false)).isEqualTo(Answer.YES);
    }

    @Test
    void givesUpWhenItIsToldTo() {
        assertThat(canDiffer(5, 4, () -> true)).isEqualTo(Answer.UNKNOWN);
    }

    /** And when it has asked often enough. */
    @Test
    void givesUpByItself() {
        assertThat(canDiffer(12, 11, () -> false)).isEqualTo(Answer.UNKNOWN);
    }

    private static Answer canDiffer(int count, int values, BooleanSupplier stop) {
        Solver solver = new Solver(stop);
        List<Term> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Term number = solver.integer("n" + i);
            solver.claim(solver.between(1, number, values));
            all.forEach(other -> solver.claim(solver.not(solver.equal(other, number))));
            all.add(number);
        }
        return solver.assuming(List.of(), () -> {});
    }
}
