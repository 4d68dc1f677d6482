package arcomat.graph;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/**
 * The strongly connected components of a graph, after Tarjan (Depth-first search and linear graph
 * algorithms, SIAM Journal on Computing 1, 1972), with a stack of its own.
 */
public final class StrongComponents {
    private static final int NONE = -1;

    private final Digraph graph;
    private final int[] component;
    private final int[] order;
    private final int[] low;
    private final int[] nextEdge;
    private final Deque<Integer> waiting = new ArrayDeque<>();
    private final List<int[]> all = new ArrayList<>();
    private int visited;

    private StrongComponents(Digraph graph) {
        this.graph = graph;
        component = new int[graph.size()];
        Arrays.fill(component, NONE);
        order = new int[graph.size()];
        low = new int[graph.size()];
        nextEdge = new int[graph.size()];
    }

    public static StrongComponents of(Digraph graph) {
        StrongComponents components = new StrongComponents(graph);
        for (int node = 0; node < graph.size(); node++) {
            if (components.order[node] == 0) {
                components.visitFrom(node);
            }
        }
        return components;
    }

    /** Whether two nodes can be reached from each other. */
    public boolean areTogether(int one, int other) {
        return component[one] == component[other];
    }

    /** All of them, each after those that it leads to, with its nodes in ascending order. */
    public List<int[]> all() {
        return all.stream().map(int[]::clone).toList();
    }

    /** Those with a cycle inside, in the same order. */
    public List<int[]> cyclic() {
        return all().stream().filter(this::isCyclic).toList();
    }

    private boolean isCyclic(int[] nodes) {
        return nodes.length > 1 || graph.successors(nodes[0]).contains(nodes[0]);
    }

    private void visitFrom(int root) {
        Deque<Integer> path = new ArrayDeque<>();
        enter(root, path);
        while (!path.isEmpty()) {
            int node = path.peek();
            if (nextEdge[node] < graph.successors(node).size()) {
                follow(node, graph.successors(node).get(nextEdge[node]++), path);
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
        order[node] = ++visited;
        low[node] = order[node];
        waiting.push(node);
        path.push(node);
    }

    private void follow(int node, int next, Deque<Integer> path) {
        if (order[next] == 0) {
            enter(next, path);
        } else if (component[next] == NONE) {
            low[node] = Math.min(low[node], order[next]);
        }
    }

    private void leave(int node) {
        if (low[node] != order[node]) {
            return;
        }
        List<Integer> members = new ArrayList<>();
        int member;
        do {
            member = waiting.pop();
            component[member] = all.size();
            members.add(member);
        } while (member != node);
        all.add(members.stream().mapToInt(Integer::intValue).sorted().toArray());
    }
}
