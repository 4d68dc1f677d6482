package arcomat.generate.plan;

import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.IntPredicate;
import java.util.function.IntUnaryOperator;

/** Finds parts of one component whose sources follow a pattern, so that a loop can serve them. */
public final class Regularity {
    /** The fewest parts for which a loop reads better than a line for each. */
    private static final int LEAST = 4;

    private static final int NONE = Integer.MIN_VALUE;

    private final Composition composition;
    private final IntUnaryOperator array;

    /**
     * @param array number of the array that holds a node; negative where none does
     */
    Regularity(Composition composition, IntUnaryOperator array) {
        this.composition = composition;
        this.array = array;
    }

    /**
     * Consecutive nodes.
     *
     * @param strides by input: how far the sources of two neighbours are apart; 0 for the same, and
     *     for a single node
     */
    public record Run(int first, int end, int[] strides) {
        public boolean isLoop() {
            return end - first > 1;
        }
    }

    /** Which inputs matter for a node. */
    interface Choice {
        boolean includes(int node, int input);
    }

    /** Divides nodes of one component into runs; where there is no pattern, a node is a run. */
    List<Run> runs(int first, int end, Choice choice, IntPredicate continues) {
        List<Run> runs = new ArrayList<>();
        int start = first;
        int[] strides = null;
        for (int node = first + 1; node < end; node++) {
            int[] next = continues.test(node) ? strides(node - 1, choice) : null;
            boolean fits = next != null && (strides == null || Arrays.equals(strides, next));
            if (fits) {
                strides = next;
            } else {
                // Two nodes alone are no pattern: the second may begin one.
                boolean restarts = next != null && node - start == 2;
                int border = restarts ? node - 1 : node;
                add(start, border, strides, runs);
                start = border;
                strides = restarts ? next : null;
            }
        }
        add(start, end, strides, runs);
        return runs;
    }

    private void add(int start, int end, int @Nullable [] strides, List<Run> runs) {
        if (end - start >= LEAST) {
            // What is longer than a node has a pattern.
            runs.add(new Run(start, end, Objects.requireNonNull(strides)));
            return;
        }
        for (int node = start; node < end; node++) {
            runs.add(new Run(node, node + 1, new int[inputs(node)]));
        }
    }

    /** From a node to the next one; null where an input follows no pattern. */
    private int @Nullable [] strides(int node, Choice choice) {
        int[] strides = new int[inputs(node)];
        for (int input = 0; input < strides.length; input++) {
            boolean included = choice.includes(node, input);
            if (included != choice.includes(node + 1, input)) {
                return null;
            }
            strides[input] = included ? stride(node, input) : 0;
            if (strides[input] == NONE) {
                return null;
            }
        }
        return strides;
    }

    /** Whether all sources of a node lie where those of the node before let expect them. */
    boolean follows(int node) {
        return strides(node - 1, (any, input) -> true) != null;
    }

    private int inputs(int node) {
        return composition.nodes().get(node).inputs().size();
    }

    private int stride(int node, int input) {
        Source one = composition.nodes().get(node).inputs().get(input);
        Source other = composition.nodes().get(node + 1).inputs().get(input);
        if (!(one instanceof Source.FromNode from) || !(other instanceof Source.FromNode next)) {
            return one.equals(other) ? 0 : NONE;
        }
        if (from.fresh() != next.fresh() || !from.port().name().equals(next.port().name())) {
            return NONE;
        }
        if (from.node() == next.node()) {
            return 0;
        }
        int holder = array.applyAsInt(from.node());
        return holder >= 0 && holder == array.applyAsInt(next.node())
                ? next.node() - from.node()
                : NONE;
    }
}
