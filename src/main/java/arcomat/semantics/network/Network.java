package arcomat.semantics.network;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * A component with concrete arguments, taken apart into its instances: what an interpreter runs.
 * Messages travel on signals, numbered from 0; a signal has one sender, an external input or an
 * output port of an instance, and any number of receivers. Evaluating the instances in order, each
 * reads what is visible in the slice: {@link Composition} says why.
 *
 * <p>Event-driven: a message goes to all receivers of its signal, in the order of instances and
 * then of input ports. A latched port stores it; any other port puts an event into the queue of its
 * instance. Run to completion: as long as a queue holds an event, the instances are visited in
 * order, again and again, and each takes one event from its queue and reacts; messages of a
 * reaction are sent in the order of its output ports.
 *
 * @param component the whole
 * @param arguments one per parameter of the whole
 * @param instances atomic components, in schedule order
 * @param inputs ports of the whole, then output ports of platform components, by instance path
 * @param outputs ports of the whole, then input ports of platform components, by instance path
 * @param signals how many there are
 * @param devices platform components, in schedule order
 */
public record Network(
        Component component,
        List<Value> arguments,
        List<Instance> instances,
        List<External> inputs,
        List<External> outputs,
        int signals,
        List<Device> devices) {

    /** The signal of a port that has no sender. */
    public static final int UNCONNECTED = -1;

    public Network {
        arguments = List.copyOf(arguments);
        instances = List.copyOf(instances);
        inputs = List.copyOf(inputs);
        outputs = List.copyOf(outputs);
        devices = List.copyOf(devices);
    }

    /**
     * A platform component at its place.
     *
     * @param path names from the whole to the instance, with dots
     */
    public record Device(String path, Component component, List<Value> arguments) {
        public Device {
            arguments = List.copyOf(arguments);
        }
    }

    /**
     * An atomic component at its place.
     *
     * @param path names from the whole to the instance, with dots; empty for the whole itself
     * @param inputSignals one per input port of the component
     * @param outputSignals one per output port of the component
     */
    public record Instance(
            String path,
            Component component,
            List<Value> arguments,
            List<Integer> inputSignals,
            List<Integer> outputSignals) {
        public Instance {
            arguments = List.copyOf(arguments);
            inputSignals = List.copyOf(inputSignals);
            outputSignals = List.copyOf(outputSignals);
        }

        /** A problem, with the path of the instance that has it. */
        public String with(String problem) {
            return path.isEmpty() ? problem : path + ": " + problem;
        }
    }

    /**
     * A port by which the network meets its surroundings.
     *
     * @param name of the port; for a platform component with its instance path, {@code left.value}
     * @param signal {@link #UNCONNECTED} for an output that nobody sends to
     */
    public record External(String name, Port port, int signal) {}

    /**
     * The signals that are sent with a delay. Where one leaves through the input of a platform
     * component, that port does not tell.
     */
    public Set<Integer> delayed() {
        Set<Integer> delayed = new LinkedHashSet<>();
        for (Instance instance : instances) {
            List<Port> outputs = instance.component().outputs();
            for (int i = 0; i < outputs.size(); i++) {
                if (outputs.get(i).delay() > 0) {
                    delayed.add(instance.outputSignals().get(i));
                }
            }
        }
        return delayed;
    }

    /**
     * Elaborates a component in time linear in the number of its instances.
     *
     * @param arguments one per parameter
     * @throws IllegalArgumentException if their number differs, or messages circle without delay
     */
    public static Network of(Component component, List<Value> arguments) {
        return new Elaboration(component, arguments).network();
    }
}
