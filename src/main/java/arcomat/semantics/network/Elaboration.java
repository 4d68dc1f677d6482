package arcomat.semantics.network;

import arcomat.model.Component;
import arcomat.model.Parameter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Effect;
import arcomat.semantics.expression.Fault;
import arcomat.semantics.expression.Scope;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/** Takes a component apart: first every sender gets its signal, then every receiver. */
final class Elaboration {
    private final Component whole;
    private final List<Value> arguments;
    private final Map<Component, Composition> compositions = new IdentityHashMap<>();
    private final Map<Component, Map<String, Integer>> positions = new IdentityHashMap<>();
    private final List<Network.Instance> instances = new ArrayList<>();
    private final List<Network.External> inputs = new ArrayList<>();
    private final List<Network.External> outputs = new ArrayList<>();
    private final List<Network.Device> devices = new ArrayList<>();
    private int signals;

    /**
     * The signals of a composite.
     *
     * @param outside one per input port of the composite
     * @param first per node the signal of its first output port, unless it is a composite
     * @param inside per composite node its own signals, else null
     */
    private record Signals(int[] outside, int[] first, Signals[] inside) {}

    Elaboration(Component whole, List<Value> arguments) {
        this.whole = whole;
        this.arguments = arguments;
    }

    Network network() {
        int[] outside = new int[whole.inputs().size()];
        for (int i = 0; i < outside.length; i++) {
            outside[i] = signals++;
            Port port = whole.inputs().get(i);
            inputs.add(new Network.External(port.name(), port, outside[i]));
        }
        Scope scope = Scope.ofParameters(whole.parameters(), arguments);
        if (Composition.inside(whole, compositions).isPresent()) {
            Composition composition = Composition.of(whole, compositions);
            Signals root = allocate(composition);
            System.arraycopy(outside, 0, root.outside, 0, outside.length);
            for (Composition.Output output : composition.outputs()) {
                int signal = signal(composition, root, output.source());
                outputs.add(new Network.External(output.port().name(), output.port(), signal));
            }
            connect("", composition, root, scope);
        } else {
            single(outside);
        }
        return new Network(whole, arguments, instances, inputs, outputs, signals, devices);
    }

    private void single(int[] outside) {
        List<Integer> sent = new ArrayList<>();
        for (Port port : whole.outputs()) {
            outputs.add(new Network.External(port.name(), port, signals));
            sent.add(signals++);
        }
        List<Integer> received = Arrays.stream(outside).boxed().toList();
        instances.add(new Network.Instance("", whole, arguments, received, sent));
    }

    private Signals allocate(Composition composition) {
        int size = composition.nodes().size();
        Signals own =
                new Signals(
                        new int[composition.component().inputs().size()],
                        new int[size],
                        new Signals[size]);
        for (int i = 0; i < size; i++) {
            Composition.Node node = composition.nodes().get(i);
            if (node.inside().isPresent()) {
                own.inside[i] = allocate(node.inside().get());
            } else {
                own.first[i] = signals;
                signals += node.component().outputs().size();
            }
        }
        return own;
    }

    /** The signal that carries the messages of a source. */
    private int signal(Composition composition, Signals own, Source source) {
        return source.match(
                outside -> own.outside[position(composition.component(), outside.port())],
                from -> signal(composition, own, from),
                () -> Network.UNCONNECTED);
    }

    private int signal(Composition composition, Signals own, Source.FromNode from) {
        Composition.Node node = composition.nodes().get(from.node());
        int port = position(node.component(), from.port());
        if (node.inside().isEmpty()) {
            return own.first[from.node()] + port;
        }
        Composition inside = node.inside().get();
        return signal(inside, own.inside[from.node()], inside.outputs().get(port).source());
    }

    /** The position among the ports of the same direction. */
    private int position(Component component, Port port) {
        Map<String, Integer> known = positions.get(component);
        if (known == null) {
            Map<String, Integer> fresh = new HashMap<>();
            List<Port> ports = component.inputs();
            ports.forEach(p -> fresh.put(p.name(), fresh.size()));
            component.outputs().forEach(p -> fresh.put(p.name(), fresh.size() - ports.size()));
            positions.put(component, fresh);
            known = fresh;
        }
        return Objects.requireNonNull(known.get(port.name()));
    }

    private void connect(String prefix, Composition composition, Signals own, Scope scope) {
        for (int i = 0; i < composition.nodes().size(); i++) {
            Composition.Node node = composition.nodes().get(i);
            String path = prefix + node.path();
            List<Integer> received = new ArrayList<>(node.inputs().size());
            for (Source source : node.inputs()) {
                received.add(signal(composition, own, source));
            }
            List<Value> values = arguments(composition.component(), node, scope);
            if (node.inside().isPresent()) {
                for (int k = 0; k < received.size(); k++) {
                    own.inside[i].outside[k] = received.get(k);
                }
                Scope inner = Scope.ofParameters(node.component().parameters(), values);
                connect(path + ".", node.inside().get(), own.inside[i], inner);
            } else {
                place(path, node.component(), values, received, own.first[i]);
            }
        }
    }

    private static List<Value> arguments(Component whole, Composition.Node node, Scope scope) {
        List<Value> values = new ArrayList<>();
        try {
            for (Parameter parameter : node.component().parameters()) {
                Value value = scope.constant(node.arguments().get(values.size()));
                values.add(Effect.inRange(parameter.name(), parameter.type(), value));
            }
        } catch (Fault fault) {
            throw fault.in(Fault.place(whole, node.path()));
        }
        return values;
    }

    private void place(
            String path,
            Component component,
            List<Value> values,
            List<Integer> received,
            int firstOutput) {
        List<Integer> sent = new ArrayList<>();
        for (int k = 0; k < component.outputs().size(); k++) {
            sent.add(firstOutput + k);
        }
        if (!component.platform()) {
            instances.add(new Network.Instance(path, component, values, received, sent));
            return;
        }
        devices.add(new Network.Device(path, component, values));
        for (int k = 0; k < sent.size(); k++) {
            Port port = component.outputs().get(k);
            inputs.add(new Network.External(path + "." + port.name(), port, sent.get(k)));
        }
        for (int k = 0; k < received.size(); k++) {
            Port port = component.inputs().get(k);
            outputs.add(new Network.External(path + "." + port.name(), port, received.get(k)));
        }
    }
}
