package arcomat.graph;

import java.util.ArrayList;
import java.util.List;
import java.util.PriorityQueue;

/** An order in which edges lead forward, after Kahn (Communications of the ACM 5, 1962). */
public final class TopologicalOrder {
    private TopologicalOrder() {}

    /**
     * The nodes so that each comes after all that lead to it, the lowest first of those that may
     * come next. What is on a cycle, or can be reached from one, is left out.
     */
    public static List<Integer> of(Digraph graph) {
        int[] awaited = new int[graph.size()];
        for (int node = 0; node < awaited.length; node++) {
            graph.successors(node).forEach(next -> awaited[next]++);
        }
        PriorityQueue<Integer> ready = new PriorityQueue<>();
        for (int node = 0; node < awaited.length; node++) {
            if (awaited[node] == 0) {
                ready.add(node);
            }
        }
        List<Integer> order = new ArrayList<>(graph.size());
        while (!ready.isEmpty()) {
            int node = ready.remove();
            order.add(node);
            for (int next : graph.successors(node)) {
                if (--awaited[next] == 0) {
                    ready.add(next);
                }
            }
        }
        return order;
    }
}
