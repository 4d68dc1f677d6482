package arcomat.analysis.evolution;

import arcomat.analysis.RandomSketches;
import arcomat.analysis.RandomSketches.Knobs;
import arcomat.analysis.Sketch;
import arcomat.analysis.Sketch.Edge;
import arcomat.analysis.Sketch.Shape;
import arcomat.model.Automaton.Completion;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;

/** The rows of the table of edits: what is done to an automaton at one of its transitions. */
enum EditRow {
    DROP_ONE_OF_TWO {
        @Override
        Optional<Sketch> apply(Sketch sketch, Edge edge, Random random) {
            return alternatives(sketch, edge) == 2
                    ? Optional.of(sketch.replacing(edge))
                    : Optional.empty();
        }
    },
    DROP_THE_ONLY_ONE {
        @Override
        Optional<Sketch> apply(Sketch sketch, Edge edge, Random random) {
            return alternatives(sketch, edge) == 1 && !edge.output().isEmpty()
                    ? Optional.of(sketch.replacing(edge))
                    : Optional.empty();
        }
    },
    ADD_A_LOOP {
        @Override
        Optional<Sketch> apply(Sketch sketch, Edge edge, Random random) {
            return unhandled(sketch, edge.source(), random)
                    .map(open -> plus(sketch, open.sending("out = x0")));
        }
    },
    ADD_A_CHANGE_OF_STATE {
        @Override
        Optional<Sketch> apply(Sketch sketch, Edge edge, Random random) {
            int target = random.nextInt(sketch.states());
            return unhandled(sketch, edge.source(), random)
                    .filter(open -> target != open.source())
                    .map(open -> plus(sketch, open.to(target).sending("out = x0")));
        }
    },
    ASSIGN_AN_OMITTED_OUTPUT {
        @Override
        Optional<Sketch> apply(Sketch sketch, Edge edge, Random random) {
            return edge.output().isEmpty()
                    ? Optional.of(sketch.replacing(edge, edge.sending("out = x0")))
                    : Optional.empty();
        }
    };

    /** An automaton with a place in it that can be reached, and with the edited one. */
    record Edited(Sketch before, Sketch after) {}

    abstract Optional<Sketch> apply(Sketch sketch, Edge edge, Random random);

    Arbitrary<Edited> with(Completion completion, boolean free) {
        return Arbitraries.randomValue(random -> draw(completion, free, random));
    }

    private Edited draw(Completion completion, boolean free, Random random) {
        while (true) {
            Shape shape =
                    new Shape(
                            1 + random.nextInt(3),
                            2,
                            random.nextBoolean(),
                            false,
                            false,
                            false,
                            free,
                            random.nextInt(3) == 0);
            Knobs knobs = new Knobs(shape, 2 + random.nextInt(4), 40, 30, completion);
            Sketch sketch = omitting(RandomSketches.of(knobs, random));
            if (!isDetermined(sketch) || sketch.edges().isEmpty()) {
                continue;
            }
            Edge edge = sketch.edges().get(random.nextInt(sketch.edges().size()));
            Optional<Sketch> after =
                    sketch.depths()[edge.source()] < sketch.states()
                            ? apply(sketch, edge, random)
                            : Optional.empty();
            if (after.isPresent()) {
                return new Edited(sketch, after.get());
            }
        }
    }

    /** Leaves out what is said to be silent, where leaving out says something else. */
    private static Sketch omitting(Sketch sketch) {
        return sketch.withEdges(
                sketch.edges().stream()
                        .map(edge -> edge.output().equals("out = --") ? edge.sending("") : edge)
                        .toList());
    }

    /** State, input and output say where the step leads. */
    private static boolean isDetermined(Sketch sketch) {
        Set<List<Object>> seen = new HashSet<>();
        Set<List<Object>> open = new HashSet<>();
        for (Edge edge : sketch.edges()) {
            List<Object> trigger = List.of(edge.source(), edge.input());
            boolean any =
                    edge.output().contains("?") || sketch.shape().free() && edge.output().isEmpty();
            if (!seen.add(List.of(edge.source(), edge.input(), edge.output()))
                    || open.contains(trigger)
                    || any && alternatives(sketch, edge) > 1) {
                return false;
            }
            if (any) {
                open.add(trigger);
            }
        }
        return true;
    }

    private static long alternatives(Sketch sketch, Edge edge) {
        return sketch.edges().stream().filter(edge::hasTriggerOf).count();
    }

    private static Optional<Edge> unhandled(Sketch sketch, int state, Random random) {
        List<String> open = new ArrayList<>(RandomSketches.symbols(sketch.shape()));
        for (Edge edge : sketch.edges()) {
            if (edge.source() == state) {
                open.remove(edge.input());
            }
        }
        return open.isEmpty()
                ? Optional.empty()
                : Optional.of(new Edge(state, state, open.get(random.nextInt(open.size())), ""));
    }

    private static Sketch plus(Sketch sketch, Edge edge) {
        List<Edge> edges = new ArrayList<>(sketch.edges());
        edges.add(edge);
        return sketch.withEdges(edges);
    }
}
