package arcomat.analysis.search.system;

import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** How data flow through a network: a signal is one place, whoever sends and reads it. */
final class NetworkPlaces {
    private final DataSorts sorts;
    private final int[] signals;
    private final List<List<int[]>> variables = new ArrayList<>();
    private final Map<String, Integer> inputs = new HashMap<>();
    private final List<Integer> outputs = new ArrayList<>();

    /**
     * @param behaviours one per instance
     */
    NetworkPlaces(Network network, List<ComponentSemantics> behaviours, DataSorts sorts) {
        this.sorts = sorts;
        signals = new int[network.signals()];
        java.util.Arrays.fill(signals, DataPlaces.NOWHERE);
        for (Network.External input : network.inputs()) {
            inputs.put(input.name(), place(input.port(), input.signal()));
        }
        for (int part = 0; part < behaviours.size(); part++) {
            Network.Instance instance = network.instances().get(part);
            Map<String, Integer> ports = new HashMap<>();
            connect(instance.component().inputs(), instance.inputSignals(), ports);
            connect(instance.component().outputs(), instance.outputSignals(), ports);
            variables.add(
                    behaviours.get(part).relations().stream()
                            .map(relation -> relation.tellFlow(sorts, ports))
                            .toList());
        }
        for (Network.External output : network.outputs()) {
            outputs.add(place(output.port(), output.signal()));
        }
    }

    private void connect(List<Port> ports, List<Integer> wires, Map<String, Integer> places) {
        for (int i = 0; i < wires.size(); i++) {
            places.put(ports.get(i).name(), place(ports.get(i), wires.get(i)));
        }
    }

    /** A port that nothing is connected to is a place of its own. */
    private int place(Port port, int signal) {
        if (signal == Network.UNCONNECTED) {
            return sorts.place(port.type());
        }
        if (signals[signal] == DataPlaces.NOWHERE) {
            signals[signal] = sorts.place(port.type());
        }
        sorts.carries(signals[signal], port.type());
        return signals[signal];
    }

    /** By the name of the external input. */
    Map<String, Integer> inputs() {
        return inputs;
    }

    /** The place of an external output, by its position. */
    int output(int number) {
        return outputs.get(number);
    }

    /** The place of a signal; {@link DataPlaces#NOWHERE} for that of a port without a sender. */
    int signal(int number) {
        return number == Network.UNCONNECTED ? DataPlaces.NOWHERE : signals[number];
    }

    /** The places of the variables of a part, per automaton. */
    List<int[]> variables(int part) {
        return variables.get(part);
    }
}
