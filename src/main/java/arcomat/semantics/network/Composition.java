package arcomat.semantics.network;

import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Output;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A composite component, with its parts in the order in which a slice evaluates them and the
 * sources of all messages. It is a matter of the component, not of its instances: parts of the same
 * component share one composition.
 *
 * <p>Order, time-synchronous: topological by delay-0 messages, ties by declaration. A composite
 * part is one node. Where that closes a cycle that the parts inside do not have, the composite
 * parts on the cycle are dissolved: their own nodes take their place, named {@code part.node}.
 * Event-driven: the order of declaration, and nothing is dissolved.
 *
 * <p>Input ports of a composite part that lead straight to its outputs are followed through, so
 * that every source is an atomic component, a platform component, a port of the whole, or nothing.
 *
 * @param nodes in schedule order
 * @param outputs one per output port of the component, in the order of declaration
 */
public record Composition(Component component, List<Node> nodes, List<Output> outputs) {
    public Composition {
        nodes = List.copyOf(nodes);
        outputs = List.copyOf(outputs);
    }

    /**
     * A part, or a part of a dissolved part.
     *
     * @param path instance path within the composite
     * @param arguments one per parameter of the node's component, over the parameters of the whole
     * @param inputs one per input port of the node's component, in the order of declaration
     * @param inside the composition of a composite node; empty for atomic and platform components
     */
    public record Node(
            String path,
            Component component,
            List<Expression> arguments,
            List<Source> inputs,
            Optional<Composition> inside) {
        public Node {
            arguments = List.copyOf(arguments);
            inputs = List.copyOf(inputs);
        }
    }

    /** Where the messages on an output port of the composite come from. */
    public record Output(Port port, Source source) {}

    /**
     * Composes the parts, and theirs, in time linear in their number.
     *
     * @param component a composite without a cycle of delay-0 messages
     * @throws IllegalArgumentException for such a cycle, which it names
     */
    public static Composition of(Component component) {
        return of(component, new IdentityHashMap<>());
    }

    static Composition of(Component component, Map<Component, Composition> known) {
        Composition composition = known.get(component);
        if (composition == null) {
            composition = new Composer(component, known).compose();
            known.put(component, composition);
        }
        return composition;
    }

    /** The composition of what has parts that are part of the model. */
    static Optional<Composition> inside(Component component, Map<Component, Composition> known) {
        return component.isComposite() && !component.platform()
                ? Optional.of(of(component, known))
                : Optional.empty();
    }
}
