package arcomat.analysis.contradiction;

import arcomat.analysis.RandomSketches;
import arcomat.analysis.RandomSketches.Knobs;
import arcomat.analysis.Sketch;
import arcomat.analysis.Sketch.Edge;
import arcomat.analysis.Sketch.Shape;
import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Arbitrary requirements on a component with few ports. The same seed gives the same ones. */
final class RequirementSets {
    private RequirementSets() {}

    static Promise of(long seed) {
        Random random = new Random(seed);
        boolean totalOut = random.nextInt(4) == 0;
        Shape shape =
                new Shape(
                        1 + random.nextInt(2),
                        2 + random.nextInt(2),
                        random.nextInt(3) > 0,
                        totalOut,
                        random.nextInt(4) == 0,
                        random.nextInt(3) == 0,
                        random.nextInt(3) == 0,
                        !totalOut && random.nextInt(3) == 0);
        int count = 2 + random.nextInt(3);
        List<Automaton> automata = new ArrayList<>();
        Component component = null;
        List<String> openings = null;
        for (int i = 0; i < count; i++) {
            Completion completion = completion(random, totalOut);
            Knobs knobs =
                    new Knobs(
                            shape,
                            1 + random.nextInt(3),
                            30 + random.nextInt(50),
                            40 + random.nextInt(40),
                            completion);
            Sketch sketch = RandomSketches.of(knobs, random);
            openings = openings == null ? sketch.openings() : openings;
            component = beginning(sketch, random.nextInt(8) == 0 ? sketch.openings() : openings);
            automata.add(named("r" + i, component));
        }
        return Promise.of(with(automata, component), List.of());
    }

    /**
     * Requirements that go from layer to layer and ask for nothing once an input came that they do
     * not handle. What can be held against a system depends on what it has said.
     */
    static Promise layered(long seed) {
        Random random = new Random(seed);
        Shape shape = new Shape(3, 3, true, false, false, false, false, false);
        List<Automaton> automata = new ArrayList<>();
        Component component = null;
        for (int i = 0; i < 2; i++) {
            int width = 1 + random.nextInt(3);
            List<Edge> edges = new ArrayList<>();
            for (int state = 0; state <= 2 * width; state++) {
                int layer = (state + width - 1) / width;
                for (String symbol : RandomSketches.symbols(shape)) {
                    int count = random.nextInt(4);
                    for (int j = 0; j < count; j++) {
                        int target = layer * width + 1 + random.nextInt(width);
                        String answer = "out = x" + random.nextInt(3);
                        edges.add(new Edge(state, target, symbol, answer));
                    }
                }
            }
            Sketch sketch =
                    new Sketch(
                            shape,
                            Completion.CHAOS,
                            false,
                            3 * width + 1,
                            List.of("out = --"),
                            edges);
            component = sketch.component("Layered");
            automata.add(named("r" + i, component));
        }
        return Promise.of(with(automata, component), List.of());
    }

    /** Most sets agree on how to begin. */
    private static Component beginning(Sketch sketch, List<String> openings) {
        return new Sketch(
                        sketch.shape(),
                        sketch.completion(),
                        false,
                        sketch.states(),
                        openings,
                        sketch.edges())
                .component("Random");
    }

    private static Completion completion(Random random, boolean totalOut) {
        int kind = random.nextInt(10);
        return kind < 6
                ? Completion.OUTPUT
                : kind < 8
                        ? Completion.CHAOS
                        : kind < 9 || totalOut ? Completion.ERROR : Completion.IGNORE;
    }

    private static Automaton named(String name, Component component) {
        Automaton a = ((Component.Atomic) component.body()).automata().get(0);
        return new Automaton(
                name,
                a.completion(),
                a.omitted(),
                a.states(),
                a.variables(),
                a.initials(),
                a.transitions(),
                a.span());
    }

    private static Component with(List<Automaton> automata, Component c) {
        return new Component(
                c.packageName(),
                c.name(),
                c.layer(),
                c.platform(),
                c.deploy(),
                c.profile(),
                c.queueCapacity(),
                c.cycle(),
                c.parameters(),
                c.constants(),
                c.ports(),
                new Component.Atomic(automata),
                List.of(),
                List.of(),
                List.of(),
                c.span());
    }
}
