package arcomat.analysis;

import arcomat.analysis.Sketch.Edge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;

/** A small change of an automaton, in the manner of those who let requirements evolve. */
public enum Edit {
    /** Decides for one of two transitions with the same trigger. */
    DROP_ALTERNATIVE {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return pick(sketch, random, edge -> alternatives(sketch, edge) > 1)
                    .map(edge -> sketch.replacing(edge));
        }
    },
    /** Leaves open what one trigger does. */
    DROP_ONLY {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return deep(sketch, random, edge -> alternatives(sketch, edge) == 1)
                    .map(edge -> sketch.replacing(edge));
        }
    },
    /** Some transitions lead to a copy of their target, which does the same. */
    COPY_STATE {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            int old = random.nextInt(sketch.states());
            int copy = sketch.states();
            List<Edge> edges = new ArrayList<>();
            for (Edge edge : sketch.edges()) {
                edges.add(edge.target() == old && random.nextBoolean() ? edge.to(copy) : edge);
                if (edge.source() == old) {
                    edges.add(edge.from(copy));
                }
            }
            return Optional.of(sketch.withStates(copy + 1).withEdges(edges));
        }
    },
    /**
     * A choice in a state is made on the way there: of two alternatives each copy of it keeps one.
     */
    CHOOSE_EARLIER {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return deep(sketch, random, e -> e.source() > 0 && alternatives(sketch, e) > 1)
                    .map(edge -> chosenEarlier(sketch, edge));
        }
    },
    /** Handles a symbol that was not handled, and stays. */
    ADD_LOOP {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return unhandled(sketch, random).map(edge -> plus(sketch, edge));
        }
    },
    /** Handles a symbol that was not handled, and goes elsewhere. */
    ADD_MOVE {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return unhandled(sketch, random)
                    .map(edge -> plus(sketch, edge.to(random.nextInt(sketch.states()))));
        }
    },
    /** Tells inputs apart by a port that the old version did not have. */
    READ_EXTRA {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            return pick(sketch, random, edge -> !edge.input().contains("extra"))
                    .map(
                            edge ->
                                    sketch.withExtension()
                                            .replacing(
                                                    edge,
                                                    edge.with("extra = true", "note = true"),
                                                    edge.with("extra = false", "note = false"),
                                                    edge.with("extra = --", "")));
        }
    },
    /** Sends something else. */
    CHANGE_OUTPUT {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            String output = RandomSketches.answer(sketch.shape(), random);
            return deep(sketch, random, edge -> !edge.output().contains(output))
                    .map(edge -> sketch.replacing(edge, edge.sending(output)));
        }
    },
    /** Leads elsewhere. */
    CHANGE_TARGET {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            int target = random.nextInt(sketch.states());
            return deep(sketch, random, edge -> edge.target() != target)
                    .map(edge -> sketch.replacing(edge, edge.to(target)));
        }
    },
    /** One more possibility for a trigger. */
    ADD_ALTERNATIVE {
        @Override
        public Optional<Sketch> apply(Sketch sketch, Random random) {
            String output = RandomSketches.answer(sketch.shape(), random);
            return deep(sketch, random, edge -> true)
                    .map(
                            edge -> {
                                int target = random.nextInt(sketch.states());
                                Edge other = edge.to(target).sending(output);
                                return sketch.replacing(edge, edge, other);
                            });
        }
    };

    /** The changed automaton; empty where there is nothing to change. */
    public abstract Optional<Sketch> apply(Sketch sketch, Random random);

    private interface Wanted {
        boolean test(Edge edge);
    }

    private static long alternatives(Sketch sketch, Edge edge) {
        return sketch.edges().stream().filter(edge::hasTriggerOf).count();
    }

    private static Optional<Edge> pick(Sketch sketch, Random random, Wanted wanted) {
        List<Edge> found = sketch.edges().stream().filter(wanted::test).toList();
        return found.isEmpty()
                ? Optional.empty()
                : Optional.of(found.get(random.nextInt(found.size())));
    }

    /** The deepest of four that can be reached. */
    private static Optional<Edge> deep(Sketch sketch, Random random, Wanted wanted) {
        int[] depths = sketch.depths();
        Optional<Edge> best = Optional.empty();
        for (int i = 0; i < 4; i++) {
            Optional<Edge> next =
                    pick(
                            sketch,
                            random,
                            e -> wanted.test(e) && depths[e.source()] < sketch.states());
            if (best.isEmpty()
                    || next.isPresent()
                            && depths[next.get().source()] > depths[best.get().source()]) {
                best = next;
            }
        }
        return best;
    }

    private static Sketch chosenEarlier(Sketch sketch, Edge one) {
        Edge other =
                sketch.edges().stream()
                        .filter(edge -> edge.hasTriggerOf(one) && edge != one)
                        .findFirst()
                        .orElseThrow();
        int copy = sketch.states();
        List<Edge> edges = new ArrayList<>();
        for (Edge edge : sketch.edges()) {
            List<Edge> sources = new ArrayList<>();
            if (edge != other) {
                sources.add(edge);
            }
            if (edge != one && edge.source() == one.source()) {
                sources.add(edge.from(copy));
            }
            for (Edge each : sources) {
                edges.add(each);
                if (edge.target() == one.source()) {
                    edges.add(each.to(copy));
                }
            }
        }
        return sketch.withStates(copy + 1).withEdges(edges);
    }

    private static Optional<Edge> unhandled(Sketch sketch, Random random) {
        int state = random.nextInt(sketch.states());
        List<String> open = new ArrayList<>(RandomSketches.symbols(sketch.shape()));
        for (Edge edge : sketch.edges()) {
            if (edge.source() == state) {
                open.removeIf(edge.input()::startsWith);
            }
        }
        return open.isEmpty()
                ? Optional.empty()
                : Optional.of(
                        new Edge(
                                state,
                                state,
                                open.get(random.nextInt(open.size())),
                                RandomSketches.answer(sketch.shape(), random)));
    }

    private static Sketch plus(Sketch sketch, Edge edge) {
        List<Edge> edges = new ArrayList<>(sketch.edges());
        edges.add(edge);
        return sketch.withEdges(edges);
    }
}
