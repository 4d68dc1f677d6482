package arcomat.analysis.symbolic;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Whether clauses can be satisfied, by conflict-driven learning, with assumptions (Eén, Sörensson,
 * "An extensible SAT-solver", SAT 2003). Literals are numbers of variables, from 1 on, negative
 * where they are negated. The same calls give the same answers, on every machine.
 */
public final class SatSolver {
    private static final int RESTART = 100;
    private static final double CLAUSE_DECAY = 1 / 0.999;
    private static final double MOST_ACTIVE = 1e20;
    private static final int FIRST_LEARNT = 4_000;

    private static final byte FREE = 0;
    private static final byte TRUE = 1;
    private static final byte FALSE = -1;

    private int variables;
    private byte[] values = new byte[128];
    private int[] levels = new int[64];
    private @Nullable WatchedClause[] reasons = new WatchedClause[64];
    private boolean[] phases = new boolean[64];
    private boolean[] seen = new boolean[64];
    private final VariableOrder order = new VariableOrder();
    private final List<List<WatchedClause>> watches =
            new ArrayList<>(List.of(List.of(), List.of()));
    private final List<WatchedClause> learnt = new ArrayList<>();
    private final IntArrayList trail = new IntArrayList();
    private final IntArrayList limits = new IntArrayList();
    private final Consumer<int[]> proof;
    private int propagated;
    private boolean contradictory;
    private double clauseStep = 1;
    private int mostLearnt = FIRST_LEARNT;
    private long work;
    private boolean[] model = new boolean[0];
    private int[] core = new int[0];

    public SatSolver() {
        this(clause -> {});
    }

    /**
     * @param proof told each clause that is concluded, in order; the empty one is the last
     */
    public SatSolver(Consumer<int[]> proof) {
        this.proof = proof;
    }

    /** The number of a new variable. */
    public int variable() {
        variables++;
        if (variables >= levels.length) {
            values = Arrays.copyOf(values, 4 * variables);
            levels = Arrays.copyOf(levels, 2 * variables);
            reasons = Arrays.copyOf(reasons, 2 * variables);
            phases = Arrays.copyOf(phases, 2 * variables);
            seen = Arrays.copyOf(seen, 2 * variables);
        }
        watches.add(new ArrayList<>());
        watches.add(new ArrayList<>());
        order.add(variables);
        return variables;
    }

    /** At least one of the literals has to be true. */
    public void add(int... literals) {
        backTo(0);
        IntArrayList own = new IntArrayList();
        for (int literal : literals) {
            int each = own(literal);
            if (values[each] == TRUE || own.contains(each ^ 1)) {
                return;
            }
            if (values[each] == FREE && !own.contains(each)) {
                own.add(each);
            }
        }
        if (own.isEmpty()) {
            contradict();
        } else if (own.size() == 1) {
            assign(own.get(0), null);
            if (propagate() != null) {
                contradict();
            }
        } else {
            watch(new WatchedClause(own.toArray(), false));
        }
    }

    private void contradict() {
        if (!contradictory) {
            proof.accept(new int[0]);
        }
        contradictory = true;
    }

    private static int own(int literal) {
        return literal > 0 ? 2 * literal : -2 * literal + 1;
    }

    private static int shown(int own) {
        return (own & 1) == 0 ? own >> 1 : -(own >> 1);
    }

    private void watch(WatchedClause clause) {
        watches.get(clause.literals[0] ^ 1).add(clause);
        watches.get(clause.literals[1] ^ 1).add(clause);
    }

    /** How much has been done so far: a number that is equal on every machine. */
    public long work() {
        return work;
    }

    /** Whether a variable is true in the way that was found. */
    public boolean isTrue(int variable) {
        return model[variable];
    }

    /** Assumptions of which one has to be given up, after a question without an answer. */
    public int[] core() {
        return core.clone();
    }

    /** Whether all clauses can be true, together with some literals. */
    public boolean solve(int... assumptions) {
        return answer(Long.MAX_VALUE, assumptions).orElseThrow();
    }

    /**
     * Whether a way is found in which they can, before so much work has been done; else nothing is
     * said.
     */
    boolean finds(long most, int... assumptions) {
        return answer(work + most, assumptions).orElse(false);
    }

    /** Whether all clauses can be true; nothing where that takes more work than until then. */
    Optional<Boolean> answer(long until, int... assumptions) {
        core = new int[0];
        backTo(0);
        int conflicts = 0;
        int restarts = 0;
        while (!contradictory) {
            WatchedClause conflict = propagate();
            if (conflict != null && limits.isEmpty()) {
                contradict();
            } else if (conflict != null) {
                conflicts++;
                learn(conflict);
            } else if (conflicts >= RESTART * luby(restarts)) {
                conflicts = 0;
                restarts++;
                backTo(0);
                forget();
                if (work > until) {
                    return Optional.empty();
                }
            } else if (limits.size() < assumptions.length) {
                if (!assume(own(assumptions[limits.size()]))) {
                    return Optional.of(false);
                }
            } else if (!decide()) {
                remember();
                return Optional.of(true);
            }
        }
        return Optional.of(false);
    }

    /** The sequence 1 1 2 1 1 2 4 .. (Luby, Sinclair, Zuckerman 1993), from 0 on. */
    private static int luby(int which) {
        int size = 1;
        int power = 0;
        while (size < which + 1) {
            power++;
            size = 2 * size + 1;
        }
        int rest = which;
        while (size - 1 != rest) {
            size = (size - 1) / 2;
            power--;
            rest %= size;
        }
        return 1 << power;
    }

    /** Whether it can be assumed; else the core says which assumptions are against it. */
    private boolean assume(int literal) {
        if (values[literal] == FALSE) {
            core = against(literal);
            return false;
        }
        limits.add(trail.size());
        if (values[literal] == FREE) {
            assign(literal, null);
        }
        return true;
    }

    /** Whether there was anything left to decide. */
    private boolean decide() {
        while (!order.isEmpty()) {
            int variable = order.take();
            if (values[2 * variable] == FREE) {
                limits.add(trail.size());
                assign(2 * variable + (phases[variable] ? 0 : 1), null);
                return true;
            }
        }
        return false;
    }

    private void remember() {
        model = new boolean[variables + 1];
        for (int variable = 1; variable <= variables; variable++) {
            model[variable] = values[2 * variable] == TRUE;
        }
    }

    private void assign(int literal, @Nullable WatchedClause reason) {
        int variable = literal >> 1;
        values[literal] = TRUE;
        values[literal ^ 1] = FALSE;
        levels[variable] = limits.size();
        reasons[variable] = reason;
        trail.add(literal);
    }

    private void backTo(int level) {
        if (limits.size() <= level) {
            return;
        }
        int start = limits.get(level);
        for (int i = trail.size() - 1; i >= start; i--) {
            int literal = trail.get(i);
            int variable = literal >> 1;
            values[literal] = FREE;
            values[literal ^ 1] = FREE;
            phases[variable] = (literal & 1) == 0;
            order.insert(variable);
        }
        trail.elementsCount = start;
        limits.elementsCount = level;
        propagated = start;
    }

    /** The clause that cannot be true any more; null where all can. */
    private @Nullable WatchedClause propagate() {
        while (propagated < trail.size()) {
            int literal = trail.get(propagated++);
            work++;
            WatchedClause conflict = visit(literal, watches.get(literal));
            if (conflict != null) {
                return conflict;
            }
        }
        return null;
    }

    /** Clauses of which a watched literal has become false watch another one, or follow. */
    private @Nullable WatchedClause visit(int literal, List<WatchedClause> watching) {
        int kept = 0;
        WatchedClause conflict = null;
        int i = 0;
        while (i < watching.size() && conflict == null) {
            WatchedClause clause = watching.get(i++);
            if (clause.removed) {
                continue;
            }
            int[] literals = clause.literals;
            if (literals[0] == (literal ^ 1)) {
                clause.swap(0, 1);
            }
            if (values[literals[0]] != TRUE && watchesAnother(clause)) {
                continue;
            }
            watching.set(kept++, clause);
            if (values[literals[0]] == FALSE) {
                conflict = clause;
            } else if (values[literals[0]] == FREE) {
                assign(literals[0], clause);
            }
        }
        while (i < watching.size()) {
            watching.set(kept++, watching.get(i++));
        }
        watching.subList(kept, watching.size()).clear();
        return conflict;
    }

    private boolean watchesAnother(WatchedClause clause) {
        int[] literals = clause.literals;
        for (int i = 2; i < literals.length; i++) {
            if (values[literals[i]] != FALSE) {
                clause.swap(1, i);
                watches.get(literals[1] ^ 1).add(clause);
                return true;
            }
        }
        return false;
    }

    /** Adds what a conflict shows: the first point at which all its reasons meet. */
    private void learn(WatchedClause conflict) {
        IntArrayList clause = new IntArrayList();
        clause.add(0);
        int open = 0;
        int position = trail.size() - 1;
        WatchedClause reason = conflict;
        int met = -1;
        do {
            bump(reason);
            for (int literal : reason.literals) {
                int variable = literal >> 1;
                if (literal != met && !seen[variable] && levels[variable] > 0) {
                    seen[variable] = true;
                    order.bump(variable);
                    if (levels[variable] == limits.size()) {
                        open++;
                    } else {
                        clause.add(literal);
                    }
                }
            }
            while (!seen[trail.get(position) >> 1]) {
                position--;
            }
            met = trail.get(position--);
            seen[met >> 1] = false;
            open--;
            reason = reasons[met >> 1];
        } while (open > 0);
        clause.set(0, met ^ 1);
        int[] marked = clause.toArray();
        int[] shorter = withoutImplied(marked);
        for (int literal : marked) {
            seen[literal >> 1] = false;
        }
        conclude(shorter);
    }

    /** Without literals that are false because others are. */
    private int[] withoutImplied(int[] clause) {
        IntArrayList kept = new IntArrayList();
        kept.add(clause[0]);
        for (int i = 1; i < clause.length; i++) {
            if (!isImplied(clause[i])) {
                kept.add(clause[i]);
            }
        }
        return kept.toArray();
    }

    private boolean isImplied(int literal) {
        WatchedClause reason = reasons[literal >> 1];
        if (reason == null) {
            return false;
        }
        for (int other : reason.literals) {
            boolean own = other >> 1 == literal >> 1;
            if (!own && !seen[other >> 1] && levels[other >> 1] > 0) {
                return false;
            }
        }
        return true;
    }

    private void conclude(int[] literals) {
        proof.accept(Arrays.stream(literals).map(SatSolver::shown).toArray());
        int back = 0;
        for (int i = 1; i < literals.length; i++) {
            int level = levels[literals[i] >> 1];
            if (level > back) {
                back = level;
                int literal = literals[1];
                literals[1] = literals[i];
                literals[i] = literal;
            }
        }
        backTo(back);
        if (literals.length == 1) {
            assign(literals[0], null);
        } else {
            WatchedClause clause = new WatchedClause(literals, true);
            learnt.add(clause);
            watch(clause);
            bump(clause);
            assign(literals[0], clause);
        }
        order.decay();
        clauseStep *= CLAUSE_DECAY;
    }

    private void bump(WatchedClause clause) {
        if (!clause.learnt) {
            return;
        }
        clause.activity += clauseStep;
        if (clause.activity > MOST_ACTIVE) {
            learnt.forEach(each -> each.activity /= MOST_ACTIVE);
            clauseStep /= MOST_ACTIVE;
        }
    }

    /**
     * Half of what was learnt is of little use. At the lowest level, no long clause is a reason.
     */
    private void forget() {
        if (learnt.size() < mostLearnt) {
            return;
        }
        learnt.sort(Comparator.comparingDouble(each -> -each.activity));
        List<WatchedClause> rest = learnt.subList(learnt.size() / 2, learnt.size());
        rest.forEach(each -> each.removed = each.literals.length > 2);
        rest.removeIf(each -> each.removed);
        mostLearnt += mostLearnt / 10;
    }

    /** Assumptions that together exclude one more. */
    private int[] against(int literal) {
        IntArrayList found = new IntArrayList();
        found.add(shown(literal));
        seen[literal >> 1] = true;
        for (int i = trail.size() - 1; i >= 0; i--) {
            int variable = trail.get(i) >> 1;
            if (!seen[variable]) {
                continue;
            }
            seen[variable] = false;
            WatchedClause reason = reasons[variable];
            if (levels[variable] == 0) {
                continue;
            }
            if (reason == null) {
                found.add(shown(trail.get(i)));
                continue;
            }
            for (int other : reason.literals) {
                seen[other >> 1] |= levels[other >> 1] > 0 && other >> 1 != variable;
            }
        }
        return found.toArray();
    }
}
