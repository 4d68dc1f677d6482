package arcomat.semantics.network;

import arcomat.model.Component;
import arcomat.model.Port;

import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * Which inputs an output may depend on in the same slice. Where such paths close a circle, a
 * network cannot be scheduled ({@link Composition}); so whoever takes the place of a component may
 * have no path that this one does not have.
 *
 * <p>An output with delay 0 of an atomic component may depend on each of its inputs, one with delay
 * 1 on none; through parts it is a matter of paths.
 */
public final class Feedthrough {
    private final Map<Component, Map<String, BitSet>> known = new IdentityHashMap<>();
    private final Map<Component, Composition> compositions = new IdentityHashMap<>();

    /**
     * The pairs of a component.
     *
     * @param component time-synchronous, without circles
     * @param parts whether its parts count; else it is taken as one automaton with its ports
     * @return per output port, by name, the positions of the inputs that it may depend on
     */
    public static Map<String, BitSet> of(Component component, boolean parts) {
        return parts ? new Feedthrough().through(component) : atomic(component);
    }

    private static Map<String, BitSet> atomic(Component component) {
        Map<String, BitSet> found = new HashMap<>();
        for (Port output : component.outputs()) {
            BitSet inputs = new BitSet();
            inputs.set(0, output.delay() == 0 ? component.inputs().size() : 0);
            found.put(output.name(), inputs);
        }
        return found;
    }

    private Map<String, BitSet> through(Component component) {
        Map<String, BitSet> found = known.get(component);
        if (found == null) {
            Optional<Composition> inside = Composition.inside(component, compositions);
            found = inside.map(c -> new Paths(c).ofOutputs()).orElseGet(() -> atomic(component));
            known.put(component, found);
        }
        return found;
    }

    /** Paths through one composition. */
    private final class Paths {
        private final Composition composition;
        private final Map<String, Integer> inputs = new HashMap<>();

        /** By node and output port. */
        private final Map<String, BitSet> reached = new HashMap<>();

        Paths(Composition composition) {
            this.composition = composition;
            for (Port input : composition.component().inputs()) {
                inputs.put(input.name(), inputs.size());
            }
        }

        /** Nodes in the order of their evaluation: a long chain asks for no long recursion. */
        Map<String, BitSet> ofOutputs() {
            for (int node = 0; node < composition.nodes().size(); node++) {
                for (Port output : composition.nodes().get(node).component().outputs()) {
                    ofNode(node, output.name());
                }
            }
            Map<String, BitSet> found = new HashMap<>();
            for (Composition.Output output : composition.outputs()) {
                found.put(output.port().name(), ofSource(output.source()));
            }
            return found;
        }

        private BitSet ofSource(Source source) {
            return source.match(
                    outside -> single(Objects.requireNonNull(inputs.get(outside.port().name()))),
                    from -> ofNode(from.node(), from.port().name()),
                    BitSet::new);
        }

        private static BitSet single(int input) {
            BitSet found = new BitSet();
            found.set(input);
            return found;
        }

        private BitSet ofNode(int number, String output) {
            String key = number + " " + output;
            BitSet found = reached.get(key);
            if (found == null) {
                Composition.Node node = composition.nodes().get(number);
                List<Source> sources = node.inputs();
                BitSet paths = new BitSet();
                if (!node.component().platform()) {
                    Objects.requireNonNull(through(node.component()).get(output)).stream()
                            .forEach(input -> paths.or(ofSource(sources.get(input))));
                }
                found = paths;
                reached.put(key, found);
            }
            return found;
        }
    }
}
