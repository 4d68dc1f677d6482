package arcomat.symbols.bodies;

import arcomat.symbols.expressions.PortSymbol;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;

/**
 * What runs through a component without delay. Every delay-0 output of an atomic component depends
 * on all of its inputs; platform components separate, as sensors are read before actuators are set.
 */
public final class Delays {
    private final Map<ComponentSymbol, InstantGraph> graphs = new ConcurrentHashMap<>();

    /**
     * The cycles without delay that the connectors of a component close, through parts of parts as
     * well. Cycles that lie inside a part are answers for the component of that part.
     */
    public List<DelayCycle> cycles(ComponentSymbol component) {
        return component.isDecomposed() ? graph(component).cycles() : List.of();
    }

    /**
     * The delay with which an output shows a reaction: that of the atomic component it comes from,
     * 0 where an input is passed on.
     */
    public int effective(ComponentSymbol component, PortSymbol output) {
        ComponentSymbol current = component;
        PortSymbol port = output;
        Set<ComponentSymbol> seen = new HashSet<>();
        while (current.isDecomposed() && seen.add(current)) {
            Optional<ConnectorSymbol> connector = current.connectorTo(port.name());
            if (connector.isEmpty() || !connector.get().source().isResolved()) {
                return port.delay();
            }
            Optional<InstanceSymbol> instance = connector.get().source().instance();
            if (instance.isEmpty()) {
                return 0;
            }
            port = connector.get().source().port().orElseThrow();
            current = instance.get().component().orElseThrow();
        }
        return port.delay();
    }

    private InstantGraph graph(ComponentSymbol component) {
        InstantGraph known = graphs.get(component);
        if (known != null) {
            return known;
        }
        for (ComponentSymbol part : Parts.innermostFirst(component)) {
            if (!graphs.containsKey(part)) {
                graphs.put(part, InstantGraph.of(part, this::known));
            }
        }
        return Objects.requireNonNull(graphs.get(component));
    }

    /** Empty for a part that contains the whole again: that is another finding. */
    private Optional<InstantGraph> known(ComponentSymbol part) {
        return Optional.ofNullable(graphs.get(part));
    }

    /**
     * A cycle of messages in which nothing is delayed.
     *
     * @param component whose connectors close the cycle
     * @param instances in the order in which messages run, the first not repeated
     * @param connectors that lie on the cycle, in the same order
     */
    public record DelayCycle(
            ComponentSymbol component,
            List<InstanceSymbol> instances,
            List<ConnectorSymbol> connectors) {
        public DelayCycle {
            instances = List.copyOf(instances);
            connectors = List.copyOf(connectors);
        }

        /** {@code ctrl -> timer -> ctrl}. */
        public String text() {
            return instances.stream().map(InstanceSymbol::name).collect(Collectors.joining(" -> "))
                    + " -> "
                    + instances.get(0).name();
        }
    }
}
