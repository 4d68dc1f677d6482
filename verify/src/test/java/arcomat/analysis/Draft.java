package arcomat.analysis;

import static arcomat.semantics.ComponentBuilder.enumeration;

import arcomat.analysis.Sketch.Edge;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.semantics.ComponentBuilder;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * An automaton over arbitrary ports that all carry the same messages: any of them can be connected.
 * Written as {@link ComponentBuilder} reads it; states are numbers.
 */
public record Draft(
        List<Socket> sockets,
        Completion completion,
        boolean free,
        int states,
        List<Opening> openings,
        List<Edge> edges) {
    static final List<String> MESSAGES = List.of("m", "n");

    private static final Type TYPE = enumeration("Message", MESSAGES.toArray(String[]::new));

    public Draft {
        sockets = List.copyOf(sockets);
        openings = List.copyOf(openings);
        edges = List.copyOf(edges);
    }

    /**
     * A port.
     *
     * @param delay of an output
     */
    public record Socket(String name, boolean input, boolean total, int delay) {
        Socket withDelay(int slices) {
            return new Socket(name, input, total, slices);
        }

        public void add(ComponentBuilder builder) {
            if (input && total) {
                builder.totalIn(TYPE, name);
            } else if (input) {
                builder.in(TYPE, name);
            } else if (delay == 0) {
                builder.instantOut(TYPE, name);
            } else if (total) {
                builder.totalOut(TYPE, name);
            } else {
                builder.out(TYPE, name);
            }
        }
    }

    /** An initial clause. */
    public record Opening(int state, String output) {}

    List<Socket> inputs() {
        return sockets.stream().filter(Socket::input).toList();
    }

    List<Socket> outputs() {
        return sockets.stream().filter(each -> !each.input()).toList();
    }

    public Draft with(Completion other) {
        return new Draft(sockets, other, free, states, openings, edges);
    }

    private Draft with(List<Edge> others) {
        return new Draft(sockets, completion, free, states, openings, others);
    }

    /** A transition more, less, or with another target or output; rather a late one. */
    Draft edited(Random random) {
        if (edges.isEmpty()) {
            return this;
        }
        List<Edge> changed = new ArrayList<>(edges);
        int size = edges.size();
        int position = Math.max(random.nextInt(size), random.nextInt(size));
        Edge old = edges.get(position);
        switch (random.nextInt(4)) {
            case 0 -> changed.remove(position);
            case 1 -> changed.add(old.to(random.nextInt(states)));
            case 2 -> changed.set(position, old.to(random.nextInt(states)));
            default -> {
                int other = random.nextInt(size);
                changed.set(position, old.sending(edges.get(other).output()));
            }
        }
        return with(changed);
    }

    public Component component(String name) {
        ComponentBuilder builder = ComponentBuilder.component(name);
        sockets.forEach(socket -> socket.add(builder));
        String[] names = IntStream.range(0, states).mapToObj(i -> "s" + i).toArray(String[]::new);
        ComponentBuilder.AutomatonBuilder automaton = builder.automaton(completion, names);
        if (free) {
            automaton.free();
        }
        openings.forEach(each -> automaton.initial("s" + each.state, each.output));
        for (Edge edge : edges) {
            automaton.on(
                    "s" + edge.source() + " -> s" + edge.target(), edge.input(), edge.output());
        }
        return automaton.build();
    }
}
