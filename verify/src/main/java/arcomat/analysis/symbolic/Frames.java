package arcomat.analysis.symbolic;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.IntStream;

/**
 * What is known of the states that can be reached in at most so many steps: cubes that none of them
 * is in, each at the highest level for which that is known, and a solver that knows the same. A
 * cube is a set of literals that count positions of the state from 1 on.
 */
final class Frames {
    /** Clauses of single questions, which a solver keeps: so many, then there is a new one. */
    private static final int MOST_QUESTIONS = 3_000;

    private final TransitionRelation relation;
    private final Runnable between;
    private final List<List<int[]>> blocked = new ArrayList<>();
    private final List<Integer> marks = new ArrayList<>();
    private SatSolver solver = new SatSolver();
    private int questions;
    private long workBefore;

    /**
     * @param between called before each question; may throw to give up
     */
    Frames(TransitionRelation relation, Runnable between) {
        this.relation = relation;
        this.between = between;
        blocked.add(new ArrayList<>());
        renew();
    }

    private void renew() {
        workBefore += solver.work();
        questions = 0;
        solver = relation.clauses().into(new SatSolver());
        marks.clear();
        for (int level = 0; level < blocked.size(); level++) {
            marks.add(solver.variable());
        }
        begin(marks.get(0));
        for (int level = 1; level < blocked.size(); level++) {
            for (int[] cube : blocked.get(level)) {
                add(level, cube);
            }
        }
    }

    /** The lowest level are the beginnings. */
    private void begin(int mark) {
        List<boolean[]> initial = relation.initial();
        int[] which = new int[initial.size() + 1];
        which[initial.size()] = -mark;
        for (int i = 0; i < initial.size(); i++) {
            which[i] = solver.variable();
            for (int position = 0; position < relation.state().length; position++) {
                int literal = initial.get(i)[position] ? position + 1 : -position - 1;
                solver.add(-which[i], relation.before(literal));
            }
        }
        solver.add(which);
    }

    private void add(int level, int[] cube) {
        solver.add(clause(-marks.get(level), cube, relation::before));
    }

    /** Not all of a cube, or the other literal. */
    private static int[] clause(int other, int[] cube, IntUnaryOperator literal) {
        int[] clause = Arrays.copyOf(cube, cube.length + 1);
        clause[cube.length] = other;
        for (int i = 0; i < cube.length; i++) {
            clause[i] = -literal.applyAsInt(cube[i]);
        }
        return clause;
    }

    long work() {
        return workBefore + solver.work();
    }

    /** The highest level. */
    int top() {
        return blocked.size() - 1;
    }

    void addLevel() {
        blocked.add(new ArrayList<>());
        marks.add(solver.variable());
    }

    /** The cubes that are blocked on a level, and on none above. */
    List<int[]> at(int level) {
        return blocked.get(level);
    }

    /** Blocks a cube up to a level; smaller ones that it contains are forgotten. */
    void block(int level, int[] cube) {
        for (int below = 1; below <= level; below++) {
            blocked.get(below).removeIf(known -> contains(known, cube));
        }
        blocked.get(level).add(cube);
        add(level, cube);
    }

    /** Whether a cube is known to be out of reach at a level. */
    boolean isBlocked(int level, int[] cube) {
        for (int each = level; each <= top(); each++) {
            if (blocked.get(each).stream().anyMatch(known -> contains(cube, known))) {
                return true;
            }
        }
        return false;
    }

    /** Whether all literals of one are among those of the other; both are sorted. */
    private static boolean contains(int[] cube, int[] fewer) {
        int position = 0;
        for (int literal : fewer) {
            while (position < cube.length && cube[position] < literal) {
                position++;
            }
            if (position == cube.length || cube[position] != literal) {
                return false;
            }
        }
        return true;
    }

    private boolean ask(int level, int... assumptions) {
        between.run();
        int[] all = new int[marks.size() - level + assumptions.length];
        for (int i = level; i < marks.size(); i++) {
            all[i - level] = marks.get(i);
        }
        System.arraycopy(assumptions, 0, all, marks.size() - level, assumptions.length);
        return solver.solve(all);
    }

    /** Whether a bad step is possible at the highest level; {@link #bad} tells from where. */
    boolean hasBadStep() {
        return ask(top(), relation.bad());
    }

    /** Some states at the highest level from which a bad step leads, as just found. */
    int[] bad() {
        return lifted(found(), -relation.bad());
    }

    /**
     * Whether a step may lead into a cube, from a state on a level that is not in it.
     *
     * @return literals that keep it from that; null where one may
     */
    int @Nullable [] unreachable(int level, int[] cube, boolean fromOutside) {
        int outside = question();
        if (fromOutside) {
            solver.add(clause(-outside, cube, relation::before));
        }
        int[] assumptions = new int[cube.length + 2];
        assumptions[0] = outside;
        assumptions[1] = relation.goesOn();
        for (int i = 0; i < cube.length; i++) {
            assumptions[i + 2] = relation.after(cube[i]);
        }
        int[] needed = ask(level, assumptions) ? null : needed(cube, relation::after);
        solver.add(-outside);
        return needed;
    }

    private int question() {
        if (++questions > MOST_QUESTIONS) {
            renew();
        }
        return solver.variable();
    }

    /** Some states from which a step leads into a cube, as just found. */
    int[] before(int[] cube) {
        Found found = found();
        int outside = question();
        int[] clause = clause(-outside, cube, relation::after);
        int[] orEnds = Arrays.copyOf(clause, clause.length + 1);
        orEnds[clause.length] = -relation.goesOn();
        solver.add(orEnds);
        int[] lifted = lifted(found, outside);
        solver.add(-outside);
        return lifted;
    }

    /**
     * A state with a step out of it.
     *
     * @param cube the state, as literals that count positions
     * @param inputs the other literals that determine the step
     */
    private record Found(int[] cube, int[] inputs) {}

    private Found found() {
        boolean[] alternative = relation.alternative();
        int[] state = relation.state();
        int[] cube =
                IntStream.range(0, state.length)
                        .filter(i -> !alternative[i] || !solver.isTrue(state[i]))
                        .map(i -> solver.isTrue(state[i]) ? i + 1 : -i - 1)
                        .sorted()
                        .toArray();
        int[] inputs =
                IntStream.of(relation.inputs())
                        .map(each -> solver.isTrue(each) ? each : -each)
                        .toArray();
        return new Found(cube, inputs);
    }

    /**
     * What of a state matters: with these inputs, no state that is as that one there does the
     * contrary (Chockler, Ivrii, Matsliah, Moran, Nevo, "Incremental formal verification of
     * hardware", FMCAD 2011).
     */
    private int[] lifted(Found found, int contrary) {
        between.run();
        IntStream state = IntStream.of(found.cube).map(relation::before);
        IntStream rest = IntStream.concat(IntStream.of(contrary), IntStream.of(found.inputs));
        return solver.solve(IntStream.concat(rest, state).toArray())
                ? found.cube
                : needed(found.cube, relation::before);
    }

    /** Those literals of a cube that a question had no answer for. */
    private int[] needed(int[] cube, IntUnaryOperator literal) {
        int[] core = solver.core();
        Arrays.sort(core);
        return IntStream.of(cube)
                .filter(each -> Arrays.binarySearch(core, literal.applyAsInt(each)) >= 0)
                .toArray();
    }
}
