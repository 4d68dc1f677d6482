package arcomat.symbols;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;

/** A directed graph over the numbers below its size. No search here recurses. */
final class Graph {
    private final List<List<Integer>> successors = new ArrayList<>();

    Graph(int size) {
        for (int i = 0; i < size; i++) {
            successors.add(new ArrayList<>(2));
        }
    }

    int addNode() {
        successors.add(new ArrayList<>(2));
        return successors.size() - 1;
    }

    void addEdge(int from, int to) {
        successors.get(from).add(to);
    }

    int size() {
        return successors.size();
    }

    /** All nodes that can be reached from one, itself included only if it lies on a cycle. */
    BitSet reachableFrom(int start) {
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

    /** One shortest cycle through the lowest node of every strongly connected part that has one. */
    List<List<Integer>> cycles() {
        int[] parts = parts();
        boolean[] done = new boolean[size()];
        List<List<Integer>> cycles = new ArrayList<>();
        for (int node = 0; node < size(); node++) {
            if (!done[parts[node]]) {
                done[parts[node]] = true;
                List<Integer> cycle = shortestCycle(node, parts);
                if (!cycle.isEmpty()) {
                    cycles.add(cycle);
                }
            }
        }
        return cycles;
    }

    private List<Integer> shortestCycle(int start, int[] parts) {
        int[] previous = new int[0];
        Deque<Integer> open = new ArrayDeque<>(List.of(start));
        while (!open.isEmpty()) {
            int node = open.remove();
            for (int next : successors.get(node)) {
                if (next == start) {
                    return path(start, node, previous);
                }
                if (parts[next] == parts[start]) {
                    if (previous.length == 0) {
                        previous = new int[size()];
                        Arrays.fill(previous, -1);
                    }
                    if (previous[next] < 0) {
                        previous[next] = node;
                        open.add(next);
                    }
                }
            }
        }
        return List.of();
    }

    private static List<Integer> path(int start, int end, int[] previous) {
        List<Integer> path = new ArrayList<>();
        for (int node = end; node != start; node = previous[node]) {
            path.add(0, node);
        }
        path.add(0, start);
        return path;
    }

    /** Tarjan's algorithm with a stack of its own: the number of the part each node belongs to. */
    private int[] parts() {
        int size = size();
        int[] part = new int[size];
        int[] order = new int[size];
        int[] low = new int[size];
        int[] nextEdge = new int[size];
        Arrays.fill(part, -1);
        Deque<Integer> path = new ArrayDeque<>();
        Deque<Integer> waiting = new ArrayDeque<>();
        int visited = 0;
        int found = 0;
        for (int root = 0; root < size; root++) {
            if (order[root] == 0) {
                path.push(root);
            }
            while (!path.isEmpty()) {
                int node = path.peek();
                if (order[node] == 0) {
                    order[node] = ++visited;
                    low[node] = order[node];
                    waiting.push(node);
                }
                if (nextEdge[node] < successors.get(node).size()) {
                    int next = successors.get(node).get(nextEdge[node]++);
                    if (order[next] == 0) {
                        path.push(next);
                    } else if (part[next] < 0) {
                        low[node] = Math.min(low[node], order[next]);
                    }
                    continue;
                }
                path.pop();
                if (!path.isEmpty()) {
                    low[path.peek()] = Math.min(low[path.peek()], low[node]);
                }
                if (low[node] == order[node]) {
                    int member;
                    do {
                        member = waiting.pop();
                        part[member] = found;
                    } while (member != node);
                    found++;
                }
            }
        }
        return part;
    }
}
