package arcomat.analysis.search.composition;

import arcomat.model.Port;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.MessageClasses;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Who sends and who reads each signal of a network. */
public final class Wiring {

    /** An input port of a part. */
    public record Reader(int part, int port) {}

    private final Network network;
    final boolean[] delayed;
    final List<List<Reader>> readers = new ArrayList<>();

    /** Per signal, whether the outside sees it too. */
    final boolean[] observed;

    /** Per signal, whether the outside sees it, and a part or another port of the outside too. */
    final boolean[] shared;

    /** Per signal the port that sends it. */
    final Port[] sender;

    /**
     * @param compared names of the outputs that the outside looks at
     */
    Wiring(Network network, List<String> compared) {
        this.network = network;
        delayed = new boolean[network.signals()];
        observed = new boolean[network.signals()];
        shared = new boolean[network.signals()];
        sender = new Port[network.signals()];
        for (int i = 0; i < network.signals(); i++) {
            readers.add(new ArrayList<>());
        }
        network.inputs().forEach(input -> sender[input.signal()] = input.port());
        for (int part = 0; part < network.instances().size(); part++) {
            connect(network.instances().get(part), part);
        }
        for (Network.External output : network.outputs()) {
            if (output.signal() != Network.UNCONNECTED && compared.contains(output.name())) {
                int signal = output.signal();
                shared[signal] = observed[signal] || !readers.get(signal).isEmpty();
                observed[signal] = true;
            }
        }
    }

    private void connect(Network.Instance instance, int part) {
        List<Port> outputs = instance.component().outputs();
        for (int i = 0; i < outputs.size(); i++) {
            int signal = instance.outputSignals().get(i);
            delayed[signal] = outputs.get(i).delay() > 0;
            sender[signal] = outputs.get(i);
        }
        for (int i = 0; i < instance.inputSignals().size(); i++) {
            int signal = instance.inputSignals().get(i);
            if (signal != Network.UNCONNECTED) {
                readers.get(signal).add(new Reader(part, i));
            }
        }
    }

    Port port(Reader reader) {
        return network.instances().get(reader.part()).component().inputs().get(reader.port());
    }

    Sent[] silence() {
        Sent[] silent = new Sent[delayed.length];
        Arrays.fill(silent, Sent.SILENCE);
        return silent;
    }

    /**
     * What a message that is left open is divided into.
     *
     * @param present whether there is one for certain; else silence is among the samples
     */
    List<Sent> samples(int signal, boolean present, PortAbstraction look) {
        return MessageClasses.of(sender[signal], present, look).samples().stream()
                .map(Sent::of)
                .toList();
    }
}
