package arcomat.graph;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** One shortest cycle through the lowest node of every strongly connected component with one. */
public final class ShortestCycles {
    private final Digraph graph;
    private final StrongComponents components;

    private ShortestCycles(Digraph graph) {
        this.graph = graph;
        this.components = StrongComponents.of(graph);
    }

    /** Each begins with its lowest node, which is not repeated; ordered by that node. */
    public static List<List<Integer>> of(Digraph graph) {
        ShortestCycles cycles = new ShortestCycles(graph);
        return cycles.components.cyclic().stream()
                .map(nodes -> nodes[0])
                .sorted()
                .map(cycles::through)
                .toList();
    }

    /** Breadth first, inside of the component. */
    private List<Integer> through(int start) {
        Map<Integer, Integer> previous = new HashMap<>();
        Deque<Integer> open = new ArrayDeque<>(List.of(start));
        while (true) {
            int node = open.remove();
            for (int next : graph.successors(node)) {
                if (next == start) {
                    return path(start, node, previous);
                }
                if (components.areTogether(next, start)
                        && previous.putIfAbsent(next, node) == null) {
                    open.add(next);
                }
            }
        }
    }

    private static List<Integer> path(int start, int end, Map<Integer, Integer> previous) {
        List<Integer> path = new ArrayList<>();
        for (int node = end; node != start; node = Objects.requireNonNull(previous.get(node))) {
            path.add(node);
        }
        path.add(start);
        Collections.reverse(path);
        return path;
    }
}
