package arcomat.generate.plan;

import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Source;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Another order of the parts of a composite: receivers before senders of delayed messages, so that
 * a part can fetch its messages right before its step, from outputs that still show what was sent
 * in the slice before. Senders stay before receivers of messages of the same slice. Where messages
 * circle, the schedule decides who is first, and some are fetched when the slice starts.
 */
final class Reordering {
    private final Composition schedule;
    private final boolean deepFirst;
    private final List<List<Integer>> followers = new ArrayList<>();
    private final int[] waitsFor;
    private final boolean[] placed;
    private final Deque<Integer> ready = new ArrayDeque<>();
    private final int[] positions;
    private final List<Integer> order = new ArrayList<>();

    private Reordering(Composition schedule, boolean deepFirst) {
        this.schedule = schedule;
        this.deepFirst = deepFirst;
        int size = schedule.nodes().size();
        waitsFor = new int[size];
        placed = new boolean[size];
        positions = new int[size];
        for (int i = 0; i < size; i++) {
            followers.add(new ArrayList<>());
        }
    }

    /**
     * @param deepFirst chain by chain; otherwise layer by layer
     */
    static Composition of(Composition schedule, boolean deepFirst) {
        return new Reordering(schedule, deepFirst).ordered();
    }

    private Composition ordered() {
        for (int node = 0; node < waitsFor.length; node++) {
            for (Source source : schedule.nodes().get(node).inputs()) {
                if (source instanceof Source.FromNode from && from.node() != node) {
                    int first = from.fresh() ? from.node() : node;
                    int second = from.fresh() ? node : from.node();
                    followers.get(first).add(second);
                    waitsFor[second]++;
                }
            }
        }
        for (int node = 0; node < waitsFor.length; node++) {
            if (waitsFor[node] == 0) {
                ready.addLast(node);
            }
        }
        // Before a part in the schedule stand all that it must wait for: the first that is left is
        // held up by a circle only.
        for (int node = 0; node < waitsFor.length; node++) {
            placeReady();
            if (!placed[node]) {
                place(node);
            }
        }
        return renumbered();
    }

    private void placeReady() {
        while (!ready.isEmpty()) {
            int node = ready.pollFirst();
            if (!placed[node]) {
                place(node);
            }
        }
    }

    private void place(int node) {
        placed[node] = true;
        positions[node] = order.size();
        order.add(node);
        for (int follower : followers.get(node)) {
            if (--waitsFor[follower] == 0) {
                if (deepFirst) {
                    ready.addFirst(follower);
                } else {
                    ready.addLast(follower);
                }
            }
        }
    }

    private Composition renumbered() {
        List<Composition.Node> nodes = new ArrayList<>();
        for (int old : order) {
            Composition.Node node = schedule.nodes().get(old);
            nodes.add(
                    new Composition.Node(
                            node.path(),
                            node.component(),
                            node.arguments(),
                            node.inputs().stream().map(this::renumbered).toList(),
                            node.inside()));
        }
        List<Composition.Output> outputs =
                schedule.outputs().stream()
                        .map(o -> new Composition.Output(o.port(), renumbered(o.source())))
                        .toList();
        return new Composition(schedule.component(), nodes, outputs);
    }

    private Source renumbered(Source source) {
        return source instanceof Source.FromNode from
                ? new Source.FromNode(positions[from.node()], from.port(), from.fresh())
                : source;
    }
}
