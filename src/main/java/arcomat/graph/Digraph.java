package arcomat.graph;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.Deque;
import java.util.List;

/**
 * A directed graph over the numbers below its size, which grows while it is built. Edges keep their
 * order, and one that is added twice is there twice. No search over it recurses: a chain may be
 * 100,000 nodes long.
 */
public final class Digraph {
    private final List<List<Integer>> successors = new ArrayList<>();

    /**
     * @param size number of nodes to begin with, without edges
     */
    public Digraph(int size) {
        for (int i = 0; i < size; i++) {
            addNode();
        }
    }

    /** The number of a new node. */
    public int addNode() {
        successors.add(new ArrayList<>(2));
        return successors.size() - 1;
    }

    public void addEdge(int from, int to) {
        successors.get(from).add(to);
    }

    public int size() {
        return successors.size();
    }

    public List<Integer> successors(int node) {
        return Collections.unmodifiableList(successors.get(node));
    }

    /** All nodes that can be reached from one, itself included only if it lies on a cycle. */
    public BitSet reachableFrom(int start) {
        BitSet reached = new BitSet();
        Deque<Integer> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            for (int next : successors.get(open.pop())) {
                if (!reached.get(next)) {
                    reached.set(next);
                    open.push(next);
                }
            }
        }
        return reached;
    }
}
