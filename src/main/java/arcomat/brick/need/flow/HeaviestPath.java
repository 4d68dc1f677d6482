package arcomat.brick.need.flow;

import arcomat.graph.Digraph;
import arcomat.graph.StrongComponents;

import org.objectweb.asm.tree.AbstractInsnNode;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.stream.IntStream;

/**
 * The heaviest way through a method, from its start to a return. Of branches the heavier counts,
 * whether or not the way can be gone; a loop counts as often as it can go round.
 */
public final class HeaviestPath {
    private static final long UNREACHED = -1;

    /** What an instruction weighs, calls with what they call; never negative. */
    public interface Weight {
        long of(AbstractInsnNode instruction);
    }

    private final FlowGraph graph;
    private final OptionalLong rounds;
    private final long[] weights;

    private HeaviestPath(FlowGraph graph, OptionalLong rounds) {
        this.graph = graph;
        this.rounds = rounds;
        this.weights = new long[graph.size()];
    }

    /**
     * @param useful what lies on the ways that are looked at
     * @param rounds how often loops go round that do not count, if that is known
     * @throws Unknown if a loop weighs something and may go round any number of times
     */
    public static long of(FlowGraph graph, BitSet useful, OptionalLong rounds, Weight weight) {
        if (!useful.get(0)) {
            return 0;
        }
        HeaviestPath path = new HeaviestPath(graph, rounds);
        for (int i = useful.nextSetBit(0); i >= 0; i = useful.nextSetBit(i + 1)) {
            path.weights[i] = weight.of(graph.instruction(i));
        }
        long[] ways = path.from(0, useful);
        // What does not come back to its loop's head has not returned either.
        return useful.stream()
                .filter(i -> graph.after(i).isEmpty())
                .mapToLong(i -> ways[i])
                .max()
                .orElse(0);
    }

    /**
     * For each instruction the heaviest way that ends with it; those that are not reached have
     * none.
     */
    private long[] from(int start, BitSet all) {
        BitSet among = graph.among(all).reachableFrom(start);
        among.set(start);
        Digraph ways = graph.among(among);
        long[] heaviest = new long[graph.size()];
        Arrays.fill(heaviest, UNREACHED);
        List<int[]> components = StrongComponents.of(ways).all();
        // Each comes after those that it leads to, and is asked before them.
        for (int i = components.size() - 1; i >= 0; i--) {
            int first = components.get(i)[0];
            if (among.get(first)) {
                add(components.get(i), ways, start, among, heaviest);
            }
        }
        return heaviest;
    }

    private void add(int[] component, Digraph ways, int start, BitSet among, long[] heaviest) {
        BitSet nodes = new BitSet();
        IntStream.of(component).forEach(nodes::set);
        int only = component[0];
        if (component.length > 1 || ways.successors(only).contains(only)) {
            addLoop(start, nodes, among, heaviest);
        } else {
            long before = heaviestBefore(only, start, nodes, among, heaviest);
            heaviest[only] = before == UNREACHED ? UNREACHED : before + weights[only];
        }
    }

    /** The way up to an instruction that is entered from outside of its knot. */
    private long heaviestBefore(int position, int start, BitSet knot, BitSet among, long[] ways) {
        long heaviest = position == start ? 0 : UNREACHED;
        for (int each : graph.before(position)) {
            if (among.get(each) && !knot.get(each)) {
                heaviest = Math.max(heaviest, ways[each]);
            }
        }
        return heaviest;
    }

    private void addLoop(int start, BitSet loop, BitSet among, long[] ways) {
        int head = head(start, loop, among);
        long before = heaviestBefore(head, start, loop, among, ways);
        if (before == UNREACHED) {
            return;
        }
        long[] inside = fromHead(head, loop);
        long round = 0;
        for (int each : graph.before(head)) {
            if (loop.get(each)) {
                round = Math.max(round, inside[each]);
            }
        }
        long all = round == 0 ? 0 : Math.multiplyExact(rounds(loop, head), round);
        for (int i = loop.nextSetBit(0); i >= 0; i = loop.nextSetBit(i + 1)) {
            if (inside[i] != UNREACHED) {
                ways[i] = Math.addExact(Math.addExact(before, all), inside[i]);
            }
        }
    }

    private int head(int start, BitSet loop, BitSet among) {
        List<Integer> heads =
                loop.stream()
                        .filter(each -> each == start || isEntered(each, loop, among))
                        .boxed()
                        .toList();
        if (heads.size() != 1) {
            throw new Unknown("a loop has several beginnings");
        }
        return heads.get(0);
    }

    private boolean isEntered(int position, BitSet loop, BitSet among) {
        return graph.before(position).stream().anyMatch(each -> among.get(each) && !loop.get(each));
    }

    /** Ways through a loop that do not come back to its head. */
    private long[] fromHead(int head, BitSet loop) {
        BitSet rest = (BitSet) loop.clone();
        rest.clear(head);
        long[] ways = new long[graph.size()];
        Arrays.fill(ways, UNREACHED);
        ways[head] = weights[head];
        for (int next : graph.after(head)) {
            if (rest.get(next)) {
                long[] further = from(next, rest);
                for (int i = rest.nextSetBit(0); i >= 0; i = rest.nextSetBit(i + 1)) {
                    if (further[i] != UNREACHED) {
                        ways[i] = Math.max(ways[i], weights[head] + further[i]);
                    }
                }
            }
        }
        return ways;
    }

    private long rounds(BitSet loop, int head) {
        OptionalLong counted = new LoopCounter(graph, loop, head).rounds();
        if (counted.isEmpty() && rounds.isEmpty()) {
            throw new Unknown("a loop may go round any number of times");
        }
        return counted.orElseGet(rounds::getAsLong);
    }
}
