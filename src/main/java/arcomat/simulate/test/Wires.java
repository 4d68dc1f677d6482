package arcomat.simulate.test;

import arcomat.model.Port;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;

/** Who sends and who reads each signal of a network. */
final class Wires {
    private static final int OUTSIDE = -1;

    /** An input port of an instance. */
    record Reader(int instance, int port, boolean latched) {}

    private final Network network;
    private final int[] sender;
    private final Port[] port;
    private final boolean[] delayed;
    private final boolean[] shown;
    private final List<List<Reader>> readers = new ArrayList<>();
    private final Map<String, Integer> outputs = new HashMap<>();

    Wires(Network network) {
        this.network = network;
        sender = new int[network.signals()];
        port = new Port[network.signals()];
        delayed = new boolean[network.signals()];
        shown = new boolean[network.signals()];
        Arrays.fill(sender, OUTSIDE);
        for (int signal = 0; signal < network.signals(); signal++) {
            readers.add(new ArrayList<>());
        }
        network.inputs().forEach(external -> port[external.signal()] = external.port());
        for (int i = 0; i < network.instances().size(); i++) {
            connect(i, network.instances().get(i));
        }
        for (Network.External external : network.outputs()) {
            outputs.put(external.name(), external.signal());
            if (external.signal() != Network.UNCONNECTED) {
                shown[external.signal()] = true;
            }
        }
    }

    private void connect(int number, Network.Instance instance) {
        List<Port> sends = instance.component().outputs();
        for (int i = 0; i < sends.size(); i++) {
            int signal = instance.outputSignals().get(i);
            sender[signal] = number;
            port[signal] = sends.get(i);
            delayed[signal] = sends.get(i).delay() > 0;
        }
        List<Port> reads = instance.component().inputs();
        for (int i = 0; i < reads.size(); i++) {
            int signal = instance.inputSignals().get(i);
            if (signal != Network.UNCONNECTED) {
                readers.get(signal).add(new Reader(number, i, reads.get(i).latched()));
            }
        }
    }

    /** The instance that sends a signal; empty for what comes from outside. */
    OptionalInt sender(int signal) {
        return sender[signal] == OUTSIDE ? OptionalInt.empty() : OptionalInt.of(sender[signal]);
    }

    /** The port that sends a signal. */
    Port port(int signal) {
        return port[signal];
    }

    /** That port with the path of its instance. */
    String name(int signal) {
        String path =
                sender[signal] == OUTSIDE ? "" : network.instances().get(sender[signal]).path();
        return path.isEmpty() ? port[signal].name() : path + "." + port[signal].name();
    }

    List<Reader> readers(int signal) {
        return readers.get(signal);
    }

    /** Whether the messages of a signal come out of a register, known before the slice. */
    boolean isDelayed(int signal) {
        return delayed[signal];
    }

    /** Whether anybody takes notice of a signal. */
    boolean isOfUse(int signal) {
        return shown[signal] || !readers.get(signal).isEmpty();
    }

    /** The signal of an output of the whole, or {@link Network#UNCONNECTED}. */
    int output(String name) {
        return Objects.requireNonNull(outputs.get(name));
    }
}
