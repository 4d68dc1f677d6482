package arcomat.symbols.bodies;

import arcomat.graph.Digraph;
import arcomat.graph.ShortestCycles;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.Delays.DelayCycle;
import arcomat.symbols.expressions.PortSymbol;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The undelayed dependencies between the ports of a component and of its parts. */
final class InstantGraph {
    private final ComponentSymbol component;
    private final Digraph graph = new Digraph(0);
    private final Map<String, Integer> nodes = new HashMap<>();
    private final List<Optional<InstanceSymbol>> instanceOf = new ArrayList<>();
    private final Map<Long, ConnectorSymbol> connectors = new HashMap<>();
    private final Map<String, List<String>> paths = new LinkedHashMap<>();

    private InstantGraph(ComponentSymbol component) {
        this.component = component;
    }

    /**
     * @param parts the graphs of components that occur inside
     */
    static InstantGraph of(
            ComponentSymbol component, Function<ComponentSymbol, Optional<InstantGraph>> parts) {
        InstantGraph graph = new InstantGraph(component);
        if (component.isDecomposed()) {
            component.connectors().forEach(graph::addConnector);
            component.instances().forEach(instance -> graph.addInstance(instance, parts));
            graph.findPaths();
        }
        return graph;
    }

    private void addConnector(ConnectorSymbol connector) {
        if (connector.isResolved()
                && connector.source().isSender()
                && connector.target().isReceiver()) {
            int from = node(connector.source());
            int to = node(connector.target());
            graph.addEdge(from, to);
            connectors.put(edge(from, to), connector);
        }
    }

    private static long edge(int from, int to) {
        return (long) from << 32 | to;
    }

    private int node(End end) {
        return node(end.key(), end.instance());
    }

    private int node(String key, Optional<InstanceSymbol> instance) {
        return nodes.computeIfAbsent(
                key,
                k -> {
                    instanceOf.add(instance);
                    return graph.addNode();
                });
    }

    private void addInstance(
            InstanceSymbol instance, Function<ComponentSymbol, Optional<InstantGraph>> parts) {
        Optional<ComponentSymbol> type = instance.component();
        if (type.isEmpty()) {
            return;
        }
        if (type.get().isDecomposed()) {
            parts.apply(type.get()).ifPresent(inside -> addPaths(instance, inside));
        } else if (!type.get().isPlatform()) {
            addAtomic(instance, type.get());
        }
    }

    private void addPaths(InstanceSymbol instance, InstantGraph inside) {
        Optional<InstanceSymbol> self = Optional.of(instance);
        String prefix = instance.name() + ".";
        inside.paths.forEach(
                (input, outputs) -> {
                    for (String output : outputs) {
                        graph.addEdge(node(prefix + input, self), node(prefix + output, self));
                    }
                });
    }

    /** All inputs meet in a node of their own, so that edges do not multiply. */
    private void addAtomic(InstanceSymbol instance, ComponentSymbol type) {
        Optional<InstanceSymbol> self = Optional.of(instance);
        int reaction = node(instance.name() + ".", self);
        for (PortSymbol port : type.ports()) {
            String key = instance.name() + "." + port.name();
            if (port.isInput()) {
                graph.addEdge(node(key, self), reaction);
            } else if (port.delay() == 0) {
                graph.addEdge(reaction, node(key, self));
            }
        }
    }

    private void findPaths() {
        for (PortSymbol input : component.ports()) {
            Integer start = input.isInput() ? nodes.get(input.name()) : null;
            if (start == null) {
                continue;
            }
            BitSet reached = graph.reachableFrom(start);
            List<String> outputs = new ArrayList<>();
            for (PortSymbol output : component.ports()) {
                Integer end = output.isOutput() ? nodes.get(output.name()) : null;
                if (end != null && reached.get(end)) {
                    outputs.add(output.name());
                }
            }
            paths.put(input.name(), outputs);
        }
    }

    /**
     * A name that is declared twice, in and out, is a circle in itself: that is another finding.
     */
    List<DelayCycle> cycles() {
        return ShortestCycles.of(graph).stream()
                .map(this::cycle)
                .filter(c -> !c.connectors().isEmpty() && !c.instances().isEmpty())
                .toList();
    }

    private DelayCycle cycle(List<Integer> ports) {
        LinkedHashSet<InstanceSymbol> instances = new LinkedHashSet<>();
        List<ConnectorSymbol> wires = new ArrayList<>();
        for (int i = 0; i < ports.size(); i++) {
            int from = ports.get(i);
            int to = ports.get((i + 1) % ports.size());
            instanceOf.get(from).ifPresent(instances::add);
            ConnectorSymbol wire = connectors.get(edge(from, to));
            if (wire != null) {
                wires.add(wire);
            }
        }
        return new DelayCycle(component, List.copyOf(instances), wires);
    }
}
