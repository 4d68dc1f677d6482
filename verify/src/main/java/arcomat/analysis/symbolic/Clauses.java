package arcomat.analysis.symbolic;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A formula that is written down clause by clause. Literals are numbers of variables, from 1 on,
 * negative where they are negated.
 */
public final class Clauses {
    private final List<int[]> all = new ArrayList<>();
    private int variables;
    private int truth;

    /** The number of a new variable. */
    public int variable() {
        return ++variables;
    }

    /** New variables of which exactly one is true. */
    public int[] oneOf(int count) {
        int[] some = new int[count];
        Arrays.setAll(some, i -> variable());
        exactlyOne(some);
        return some;
    }

    private void exactlyOne(int[] literals) {
        add(literals);
        for (int i = 0; i < literals.length; i++) {
            for (int j = 0; j < i; j++) {
                add(-literals[i], -literals[j]);
            }
        }
    }

    /** At least one of the literals has to be true. */
    public void add(int... literals) {
        all.add(literals.clone());
    }

    /** What is always true. */
    public int truth() {
        if (truth == 0) {
            truth = variable();
            add(truth);
        }
        return truth;
    }

    /** True where at least one is (Tseitin 1968). */
    public int or(int... literals) {
        if (literals.length == 1) {
            return literals[0];
        }
        int any = variable();
        int[] longer = Arrays.copyOf(literals, literals.length + 1);
        longer[literals.length] = -any;
        add(longer);
        for (int literal : literals) {
            add(-literal, any);
        }
        return any;
    }

    /** True where all are. */
    public int and(int... literals) {
        return -or(Arrays.stream(literals).map(literal -> -literal).toArray());
    }

    /** The clauses so far; not to be written to. */
    List<int[]> all() {
        return Collections.unmodifiableList(all);
    }

    public int size() {
        return all.size();
    }

    int variables() {
        return variables;
    }

    /** The same, to be gone on with. */
    Clauses copy() {
        Clauses copy = new Clauses();
        copy.all.addAll(all);
        copy.variables = variables;
        copy.truth = truth;
        return copy;
    }

    /** Tells a solver. */
    SatSolver into(SatSolver solver) {
        for (int i = 0; i < variables; i++) {
            solver.variable();
        }
        all.forEach(solver::add);
        return solver;
    }
}
