package arcomat.brick.need;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Deque;
import java.util.List;
import java.util.function.IntFunction;

/**
 * Divides instructions into knots, of which each leads back to itself or is a single instruction:
 * in an order in which no knot leads to one before it. Kosaraju's way, without recursion.
 */
final class Knots {
    private Knots() {}

    /**
     * @param among the instructions to divide
     * @param after where an instruction leads; what is not among them is left out
     * @param before the same in the other direction
     */
    static List<BitSet> of(
            BitSet among, IntFunction<List<Integer>> after, IntFunction<List<Integer>> before) {
        List<Integer> finished = new ArrayList<>();
        BitSet seen = new BitSet();
        among.stream().forEach(start -> finish(start, among, after, seen, finished));
        Collections.reverse(finished);
        List<BitSet> knots = new ArrayList<>();
        BitSet taken = new BitSet();
        for (int start : finished) {
            if (!taken.get(start)) {
                knots.add(gather(start, among, before, taken));
            }
        }
        return knots;
    }

    private static void finish(
            int start,
            BitSet among,
            IntFunction<List<Integer>> after,
            BitSet seen,
            List<Integer> finished) {
        // A negative entry is an instruction whose ways have all been gone.
        Deque<Integer> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            int each = open.pop();
            if (each < 0) {
                finished.add(~each);
            } else if (among.get(each) && !seen.get(each)) {
                seen.set(each);
                open.push(~each);
                after.apply(each).forEach(open::push);
            }
        }
    }

    private static BitSet gather(
            int start, BitSet among, IntFunction<List<Integer>> before, BitSet taken) {
        BitSet knot = new BitSet();
        Deque<Integer> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            int each = open.pop();
            if (among.get(each) && !taken.get(each)) {
                taken.set(each);
                knot.set(each);
                before.apply(each).forEach(open::push);
            }
        }
        return knot;
    }
}
