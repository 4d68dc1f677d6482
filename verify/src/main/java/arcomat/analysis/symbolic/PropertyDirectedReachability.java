package arcomat.analysis.symbolic;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;

/**
 * Looks for an inductive invariant that excludes bad steps, by property directed reachability
 * (Bradley, "SAT-based model checking without unrolling", VMCAI 2011; Eén, Mishchenko, Brayton,
 * "Efficient implementation of property directed reachability", FMCAD 2011). Works as long as it is
 * told to, and can go on later. What it finds is to be checked: {@link InductiveInvariant}.
 */
public final class PropertyDirectedReachability implements InductiveInvariant.Search {
    /** How far it has come. */
    public enum Progress {
        /** There is more to do. */
        WORKS,
        /** There is an invariant. */
        PROVED,
        /** There is none, as far as can be seen. */
        HOPELESS
    }

    /** States that must not be reached in at most so many steps. */
    private record Obligation(int level, long number, int[] cube) {}

    private final TransitionRelation relation;
    private final Frames frames;
    private final PriorityQueue<Obligation> open =
            new PriorityQueue<>(
                    Comparator.comparingInt(Obligation::level)
                            .thenComparing(
                                    Comparator.comparingLong(Obligation::number).reversed()));
    private Progress progress = Progress.WORKS;
    private @Nullable InductiveInvariant invariant;
    private long numbers;

    /**
     * @param between called before each question to the solver; may throw to give up
     */
    public PropertyDirectedReachability(TransitionRelation relation, Runnable between) {
        this.relation = relation;
        this.frames = new Frames(relation, between);
    }

    @Override
    public Progress work(long amount) {
        long end = frames.work() + amount;
        while (progress == Progress.WORKS && frames.work() < end) {
            step();
        }
        return progress;
    }

    @Override
    public Optional<InductiveInvariant> invariant() {
        return Optional.ofNullable(invariant);
    }

    private void step() {
        Obligation first = open.peek();
        if (first != null) {
            block(first);
        } else if (frames.hasBadStep()) {
            oblige(frames.top(), frames.bad());
        } else {
            frames.addLevel();
            propagate();
        }
    }

    private void oblige(int level, int[] cube) {
        if (level == 0 || relation.beginsIn(cube)) {
            progress = Progress.HOPELESS;
        } else {
            open.add(new Obligation(level, numbers++, cube));
        }
    }

    private void block(Obligation each) {
        if (frames.isBlocked(each.level, each.cube)) {
            open.remove();
            return;
        }
        int[] needed = frames.unreachable(each.level - 1, each.cube, true);
        if (needed == null) {
            oblige(each.level - 1, frames.before(each.cube));
            return;
        }
        open.remove();
        int[] cube = generalised(each.level - 1, outside(needed, each.cube));
        int level = each.level;
        while (level < frames.top() && frames.unreachable(level, cube, true) != null) {
            level++;
        }
        frames.block(level, cube);
        if (level < frames.top()) {
            open.add(new Obligation(level + 1, numbers++, each.cube));
        }
    }

    /** With literals enough that no run begins there. */
    private int[] outside(int[] fewer, int[] cube) {
        int[] result = fewer;
        for (boolean[] state : relation.initial()) {
            if (TransitionRelation.isIn(state, result)) {
                int excluding =
                        Arrays.stream(cube)
                                .filter(each -> state[Math.abs(each) - 1] != each > 0)
                                .findFirst()
                                .orElseThrow();
                result = Arrays.copyOf(result, result.length + 1);
                result[result.length - 1] = excluding;
                Arrays.sort(result);
            }
        }
        return result;
    }

    /** Without literals that it can do without. */
    private int[] generalised(int level, int[] cube) {
        int[] best = cube;
        for (int literal : cube) {
            if (best.length == 1 || Arrays.binarySearch(best, literal) < 0) {
                continue;
            }
            int[] fewer = Arrays.stream(best).filter(each -> each != literal).toArray();
            if (relation.beginsIn(fewer)) {
                continue;
            }
            int[] needed = frames.unreachable(level, fewer, true);
            if (needed != null) {
                best = outside(needed, fewer);
            }
        }
        return best;
    }

    /** Takes what holds one step later, too, to the next level. */
    private void propagate() {
        for (int level = 1; level < frames.top(); level++) {
            for (int[] cube : new ArrayList<>(frames.at(level))) {
                if (frames.unreachable(level, cube, false) != null) {
                    frames.block(level + 1, cube);
                }
            }
            if (frames.at(level).isEmpty()) {
                invariant = new InductiveInvariant(above(level));
                progress = Progress.PROVED;
                return;
            }
        }
    }

    private List<int[]> above(int level) {
        List<int[]> cubes = new ArrayList<>();
        for (int each = level + 1; each <= frames.top(); each++) {
            cubes.addAll(frames.at(each));
        }
        return cubes;
    }
}
