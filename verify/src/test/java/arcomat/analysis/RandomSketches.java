package arcomat.analysis;

import arcomat.analysis.Sketch.Edge;
import arcomat.analysis.Sketch.Shape;
import arcomat.model.Automaton.Completion;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Arbitrary automata of a chosen size at most: not all states need to be within reach. */
public final class RandomSketches {
    private RandomSketches() {}

    /**
     * What is wanted.
     *
     * @param alternatives percentage of triggers that have two transitions
     * @param gaps percentage of symbols that a state does not handle
     */
    public record Knobs(
            Shape shape, int states, int alternatives, int gaps, Completion completion) {
        Knobs withStates(int count) {
            return new Knobs(shape, count, alternatives, gaps, completion);
        }

        public Knobs withAlternatives(int percentage) {
            return new Knobs(shape, states, percentage, gaps, completion);
        }

        Knobs withGaps(int percentage) {
            return new Knobs(shape, states, alternatives, percentage, completion);
        }

        public Knobs withCompletion(Completion other) {
            return new Knobs(shape, states, alternatives, gaps, other);
        }
    }

    /** One total input port and one output port with delay 1. */
    static Knobs plain(int states, int letters) {
        Shape shape = new Shape(letters, 3, true, false, false, false, false, false);
        return new Knobs(shape, states, 25, 15, Completion.CHAOS);
    }

    /** Any ports, completion and density, of a small automaton. */
    public static Knobs any(Random random) {
        boolean instant = random.nextInt(3) == 0;
        boolean free = random.nextInt(4) == 0;
        Completion completion = Completion.values()[random.nextInt(4)];
        boolean totalOut = !instant && completion != Completion.IGNORE && random.nextInt(4) == 0;
        Shape shape =
                new Shape(
                        1 + random.nextInt(3),
                        1 + random.nextInt(3),
                        random.nextInt(3) > 0,
                        totalOut,
                        random.nextInt(3) == 0,
                        random.nextInt(3) == 0,
                        free,
                        instant);
        return new Knobs(
                shape, 3 + random.nextInt(6), random.nextInt(40), random.nextInt(25), completion);
    }

    public static Sketch of(Knobs knobs, Random random) {
        List<Edge> edges = new ArrayList<>();
        for (int state = 0; state < knobs.states; state++) {
            for (String symbol : symbols(knobs.shape)) {
                if (random.nextInt(100) >= knobs.gaps) {
                    handle(state, symbol, knobs, random, edges);
                }
            }
        }
        List<String> openings = new ArrayList<>();
        openings.add(answer(knobs.shape, random));
        if (random.nextInt(5) == 0) {
            openings.add(answer(knobs.shape, random));
        }
        return new Sketch(knobs.shape, knobs.completion, false, knobs.states, openings, edges);
    }

    private static void handle(
            int state, String symbol, Knobs knobs, Random random, List<Edge> edges) {
        String flag = knobs.shape.flag() && random.nextInt(3) == 0 ? flag(random) : "";
        Edge trigger = new Edge(state, state, symbol, "").with(flag, "");
        int count = random.nextInt(100) < knobs.alternatives ? 2 : 1;
        for (int i = 0; i < count; i++) {
            edges.add(
                    trigger.to(target(state, knobs.states, random))
                            .sending(answer(knobs.shape, random)));
        }
    }

    /** Half of the transitions lead to the next state: long ways are wanted. */
    private static int target(int state, int states, Random random) {
        return random.nextBoolean() && state + 1 < states
                ? state + 1
                : random.nextInt(Math.min(states, state + 2));
    }

    private static String flag(Random random) {
        return "flag = " + List.of("true", "false", "?", "--").get(random.nextInt(4));
    }

    /** Every symbol that may come, as an input block. */
    public static List<String> symbols(Shape shape) {
        List<String> symbols = new ArrayList<>();
        for (int i = 0; i < shape.letters(); i++) {
            symbols.add("in = a" + i);
        }
        if (!shape.totalIn()) {
            symbols.add("in = --");
        }
        return symbols;
    }

    /** An output block. */
    static String answer(Shape shape, Random random) {
        int kind = random.nextInt(20);
        String out =
                kind == 0
                        ? "out = ?"
                        : kind < 4 && !shape.totalOut()
                                ? (shape.free() ? "out = --" : "")
                                : "out = x" + random.nextInt(shape.answers());
        if (!shape.aux() || random.nextInt(3) > 0) {
            return out;
        }
        String aux = "aux = " + random.nextBoolean();
        return out.isEmpty() ? aux : out + ", " + aux;
    }
}
