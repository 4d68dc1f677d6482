package arcomat.analysis.symbolic;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Whether clauses can be satisfied, of which more may come after each question. It is not believed
 * where it says that they cannot: its conclusions are checked one by one.
 */
public final class CheckedSolver {
    private final Clauses clauses;
    private final List<int[]> conclusions = new ArrayList<>();
    private final SatSolver solver;
    private final Runnable between;
    private final UnitPropagation check = new UnitPropagation();
    private int variables;
    private int told;

    /**
     * @param between called at each conclusion; may throw to give up for good
     */
    public CheckedSolver(Runnable between) {
        this(new Clauses(), between);
    }

    CheckedSolver(Clauses clauses, Runnable between) {
        this.clauses = clauses;
        this.between = between;
        solver =
                new SatSolver(
                        clause -> {
                            between.run();
                            conclusions.add(clause);
                        });
    }

    /** What is asked about; to be written to. */
    public Clauses clauses() {
        return clauses;
    }

    /** Whether all clauses can be true. */
    public boolean solve() {
        boolean possible = solveWith();
        if (!possible && !isConclusive()) {
            throw new IllegalStateException("a solver has drawn a wrong conclusion");
        }
        return possible;
    }

    /** Whether the conclusions so far prove that they cannot. */
    boolean isConclusive() {
        return check.refutes(clauses, conclusions, between);
    }

    /**
     * Whether they can, together with some literals; nothing where that takes more work than so
     * much.
     */
    public Optional<Boolean> answer(long most, int... literals) {
        tell();
        Optional<Boolean> answer = solver.answer(solver.work() + most, literals);
        if (answer.isPresent() && !answer.get() && !excludes(literals)) {
            throw new IllegalStateException("a solver has drawn a wrong conclusion");
        }
        return answer;
    }

    /** Whether the conclusions so far prove that some literals cannot be true together. */
    private boolean excludes(int... literals) {
        return check.excludes(clauses, conclusions, literals, between);
    }

    /** Whether they can, together with some literals. That they cannot is not checked. */
    public boolean solveWith(int... literals) {
        tell();
        return solver.solve(literals);
    }

    /**
     * Whether a way is found in which they can, together with some literals, before so much work
     * has been done; else nothing is said.
     */
    public boolean finds(long most, int... literals) {
        tell();
        return solver.finds(most, literals);
    }

    private void tell() {
        for (; variables < clauses.variables(); variables++) {
            solver.variable();
        }
        for (; told < clauses.all().size(); told++) {
            solver.add(clauses.all().get(told));
        }
    }

    /** Of each, whether it is true in the way that was found. */
    boolean[] truths(int[] literals) {
        boolean[] truths = new boolean[literals.length];
        for (int i = 0; i < truths.length; i++) {
            truths[i] = isTrue(literals[i]);
        }
        return truths;
    }

    /** How much has been done so far, in assignments: equal on every machine. */
    public long work() {
        return solver.work();
    }

    /** Whether a literal is true in the way that was found. */
    public boolean isTrue(int literal) {
        return literal > 0 == solver.isTrue(Math.abs(literal));
    }
}
