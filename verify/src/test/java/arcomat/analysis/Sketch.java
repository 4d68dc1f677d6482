package arcomat.analysis;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.enumeration;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.semantics.ComponentBuilder;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.stream.IntStream;

/**
 * An automaton that is easily changed: states are numbers, inputs and outputs are written as {@link
 * ComponentBuilder} reads them. State 0 is initial.
 *
 * <p>It reads a symbol on {@code in}, perhaps a {@code flag}, and sends an answer on {@code out},
 * perhaps a Boolean on {@code aux}. With an extension it reads a Boolean on {@code extra} and sends
 * one on {@code note}, too.
 *
 * @param openings what is sent at the beginning, each in state 0; empty with delay 0
 */
public record Sketch(
        Shape shape,
        Completion completion,
        boolean extended,
        int states,
        List<String> openings,
        List<Edge> edges) {
    public Sketch {
        openings = List.copyOf(openings);
        edges = List.copyOf(edges);
    }

    /**
     * The ports of a sketch.
     *
     * @param letters how many symbols there are
     * @param answers how many different messages there are on {@code out}
     * @param totalIn whether there is always a symbol
     * @param totalOut whether there is always an answer; only with delay 1
     * @param instant delay 0 of the outputs
     */
    public record Shape(
            int letters,
            int answers,
            boolean totalIn,
            boolean totalOut,
            boolean flag,
            boolean aux,
            boolean free,
            boolean instant) {
        private Type symbols() {
            return enumeration("Symbol", names("a", letters));
        }

        private Type answerType() {
            return enumeration("Answer", names("x", answers));
        }

        private static String[] names(String letter, int count) {
            return IntStream.range(0, count).mapToObj(i -> letter + i).toArray(String[]::new);
        }
    }

    /** A transition. */
    public record Edge(int source, int target, String input, String output) {
        public Edge to(int other) {
            return new Edge(source, other, input, output);
        }

        Edge from(int other) {
            return new Edge(other, target, input, output);
        }

        public Edge sending(String other) {
            return new Edge(source, target, input, other);
        }

        /** Another item in the input and in the output block. */
        Edge with(String moreInput, String moreOutput) {
            return new Edge(source, target, joined(input, moreInput), joined(output, moreOutput));
        }

        private static String joined(String items, String more) {
            return items.isEmpty() || more.isEmpty() ? items + more : items + ", " + more;
        }

        public boolean hasTriggerOf(Edge other) {
            return source == other.source && input.equals(other.input);
        }
    }

    public Sketch withEdges(List<Edge> others) {
        return new Sketch(shape, completion, extended, states, openings, others);
    }

    Sketch withStates(int count) {
        return new Sketch(shape, completion, extended, count, openings, edges);
    }

    Sketch withCompletion(Completion other) {
        return new Sketch(shape, other, extended, states, openings, edges);
    }

    Sketch withOpenings(List<String> others) {
        return new Sketch(shape, completion, extended, states, others, edges);
    }

    Sketch withExtension() {
        return new Sketch(shape, completion, true, states, openings, edges);
    }

    public Sketch replacing(Edge old, Edge... others) {
        List<Edge> changed = new ArrayList<>(edges);
        int position = changed.indexOf(old);
        changed.remove(position);
        changed.addAll(position, List.of(others));
        return withEdges(changed);
    }

    /** The length of a shortest path to each state by the edges; a large number where is none. */
    public int[] depths() {
        int[] depths = new int[states];
        java.util.Arrays.fill(depths, Integer.MAX_VALUE / 2);
        depths[0] = 0;
        for (int round = 0; round < states; round++) {
            for (Edge edge : edges) {
                depths[edge.target] = Math.min(depths[edge.target], depths[edge.source] + 1);
            }
        }
        return depths;
    }

    public Component component(String name) {
        ComponentBuilder builder = ports(ComponentBuilder.component(name));
        String[] names = IntStream.range(0, states).mapToObj(i -> "s" + i).toArray(String[]::new);
        ComponentBuilder.AutomatonBuilder automaton = builder.automaton(completion, names);
        if (shape.free) {
            automaton.free();
        }
        List<String> starts = shape.instant ? Collections.singletonList("") : openings;
        starts.forEach(opening -> automaton.initial("s0", opening));
        for (Edge edge : edges) {
            automaton.on("s" + edge.source + " -> s" + edge.target, edge.input, edge.output);
        }
        return automaton.build();
    }

    /** Two automata of one shape on one component, each to be satisfied. */
    static Component together(Sketch one, Sketch two, String name) {
        boolean extra = one.extended || two.extended;
        Component first = (extra ? one.withExtension() : one).component(name);
        Component second = (extra ? two.withExtension() : two).component(name);
        List<Automaton> automata = new ArrayList<>(first.automata());
        automata.addAll(second.automata());
        return new Component(
                first.packageName(),
                first.name(),
                first.layer(),
                first.platform(),
                first.deploy(),
                first.profile(),
                first.queueCapacity(),
                first.cycle(),
                first.parameters(),
                first.constants(),
                first.ports(),
                new Component.Atomic(automata),
                first.requirements(),
                first.refines(),
                List.of(),
                first.span());
    }

    private ComponentBuilder ports(ComponentBuilder builder) {
        if (shape.totalIn) {
            builder.totalIn(shape.symbols(), "in");
        } else {
            builder.in(shape.symbols(), "in");
        }
        if (shape.flag) {
            builder.in(BOOLEAN, "flag");
        }
        if (shape.totalOut) {
            builder.totalOut(shape.answerType(), "out");
        } else {
            output(builder, shape.answerType(), "out");
        }
        if (shape.aux) {
            output(builder, BOOLEAN, "aux");
        }
        if (extended) {
            builder.in(BOOLEAN, "extra");
            output(builder, BOOLEAN, "note");
        }
        return builder;
    }

    private void output(ComponentBuilder builder, Type type, String port) {
        if (shape.instant) {
            builder.instantOut(type, port);
        } else {
            builder.out(type, port);
        }
    }
}
