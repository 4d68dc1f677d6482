package arcomat.semantics;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/**
 * The strongly connected components of a graph that contain a cycle, after Tarjan (SIAM Journal on
 * Computing 1, 1972), with a stack of its own: a chain may be 100,000 nodes long.
 */
final class Cycles {
    private final int[][] edges;
    private final int[] number;
    private final int[] low;
    private final int[] nextEdge;
    private final boolean[] open;
    private final Deque<Integer> members = new ArrayDeque<>();
    private final List<int[]> cycles = new ArrayList<>();
    private int visited;

    /**
     * @param edges per node the nodes that it leads to
     */
    Cycles(int[][] edges) {
        this.edges = edges;
        number = new int[edges.length];
        low = new int[edges.length];
        nextEdge = new int[edges.length];
        open = new boolean[edges.length];
    }

    /** Each with its nodes in ascending order. */
    List<int[]> find() {
        for (int node = 0; node < edges.length; node++) {
            if (number[node] == 0) {
                visitFrom(node);
            }
        }
        return cycles;
    }

    private void visitFrom(int root) {
        Deque<Integer> path = new ArrayDeque<>();
        enter(root, path);
        while (!path.isEmpty()) {
            int node = path.peek();
            if (nextEdge[node] < edges[node].length) {
                int target = edges[node][nextEdge[node]++];
                if (number[target] == 0) {
                    enter(target, path);
                } else if (open[target]) {
                    low[node] = Math.min(low[node], number[target]);
                }
            } else {
                path.pop();
                leave(node);
                if (!path.isEmpty()) {
                    low[path.peek()] = Math.min(low[path.peek()], low[node]);
                }
            }
        }
    }

    private void enter(int node, Deque<Integer> path) {
        number[node] = ++visited;
        low[node] = number[node];
        open[node] = true;
        members.push(node);
        path.push(node);
    }

    private void leave(int node) {
        if (low[node] != number[node]) {
            return;
        }
        List<Integer> component = new ArrayList<>();
        int member;
        do {
            member = members.pop();
            open[member] = false;
            component.add(member);
        } while (member != node);
        boolean loop = Arrays.stream(edges[node]).anyMatch(target -> target == node);
        if (component.size() > 1 || loop) {
            cycles.add(component.stream().mapToInt(Integer::intValue).sorted().toArray());
        }
    }
}
