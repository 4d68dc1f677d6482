package arcomat.analysis.game;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Minimal sets with a property that larger sets have, too: one by QuickXplain (Junker 2004), all of
 * them by a hitting set tree (Reiter 1987).
 */
final class MinimalSets {
    static final Comparator<BitSet> SMALL_FIRST =
            Comparator.comparingInt(BitSet::cardinality).thenComparing(BitSet::toString);

    private MinimalSets() {}

    /** A minimal subset of a set with a property. */
    static BitSet of(BitSet set, Predicate<BitSet> property) {
        return explain(new BitSet(), false, set, property);
    }

    /** Which of the candidates are needed besides the background. */
    private static BitSet explain(
            BitSet background, boolean grown, BitSet candidates, Predicate<BitSet> property) {
        if (grown && property.test(background)) {
            return new BitSet();
        }
        if (candidates.cardinality() <= 1) {
            return candidates;
        }
        int[] members = candidates.stream().toArray();
        BitSet first = new BitSet();
        BitSet second = new BitSet();
        for (int i = 0; i < members.length; i++) {
            (i < members.length / 2 ? first : second).set(members[i]);
        }
        BitSet needed = explain(union(background, first), true, second, property);
        BitSet others = explain(union(background, needed), !needed.isEmpty(), first, property);
        return union(needed, others);
    }

    /**
     * All minimal sets, small ones first.
     *
     * @param some a minimal one within a set, if there is any
     * @param enough asked now and then whether to stop
     */
    static List<BitSet> all(
            BitSet universe, Function<BitSet, Optional<BitSet>> some, BooleanSupplier enough) {
        List<BitSet> found = new ArrayList<>();
        Set<BitSet> seen = new HashSet<>();
        Deque<BitSet> open = new ArrayDeque<>(List.of(new BitSet()));
        while (!open.isEmpty() && !enough.getAsBoolean()) {
            BitSet removed = open.removeFirst();
            Optional<BitSet> next = found.stream().filter(s -> !s.intersects(removed)).findFirst();
            if (next.isEmpty()) {
                BitSet rest = (BitSet) universe.clone();
                rest.andNot(removed);
                next = some.apply(rest);
                next.ifPresent(found::add);
            }
            for (int member : next.map(set -> set.stream().toArray()).orElse(new int[0])) {
                BitSet more = (BitSet) removed.clone();
                more.set(member);
                if (seen.add(more)) {
                    open.addLast(more);
                }
            }
        }
        found.sort(SMALL_FIRST);
        return found;
    }

    private static BitSet union(BitSet one, BitSet other) {
        BitSet union = (BitSet) one.clone();
        union.or(other);
        return union;
    }
}
