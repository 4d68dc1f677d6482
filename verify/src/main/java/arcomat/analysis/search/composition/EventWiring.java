package arcomat.analysis.search.composition;

import arcomat.model.Port;
import arcomat.semantics.automaton.ComponentSemantics.JointError;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Where messages of an event-driven network go, and where those come from that latched ports of its
 * parts hold.
 */
public final class EventWiring {
    /** In place of an external input, for what comes from elsewhere. */
    public static final int INSIDE = -1;

    private final Network network;
    private final Wiring wiring;

    /** By part and port the latched external input that feeds it, else {@code INSIDE}. */
    private final int[][] held;

    private final List<Wiring.Reader> registers = new ArrayList<>();

    /**
     * @param compared names of the outputs that the outside looks at
     */
    public EventWiring(Network network, List<String> compared) {
        this.network = network;
        this.wiring = new Wiring(network, compared);
        this.held = new int[network.instances().size()][];
        int[] latchedInputs = latchedInputs(network);
        for (int part = 0; part < held.length; part++) {
            Network.Instance instance = network.instances().get(part);
            List<Integer> signals = instance.inputSignals();
            held[part] =
                    signals.stream().mapToInt(s -> s < 0 ? INSIDE : latchedInputs[s]).toArray();
            for (int port = 0; port < held[part].length; port++) {
                boolean latched = instance.component().inputs().get(port).latched();
                if (latched && held[part][port] == INSIDE) {
                    registers.add(new Wiring.Reader(part, port));
                }
            }
        }
    }

    private static int[] latchedInputs(Network network) {
        int[] positions = new int[network.signals()];
        Arrays.fill(positions, INSIDE);
        for (int i = 0; i < network.inputs().size(); i++) {
            if (network.inputs().get(i).port().latched()) {
                positions[network.inputs().get(i).signal()] = i;
            }
        }
        return positions;
    }

    Wiring wiring() {
        return wiring;
    }

    /** The latched external input that a port of a part reads, else {@code INSIDE}. */
    public int held(int part, int port) {
        return held[part][port];
    }

    /** Latched ports of parts whose messages come from inside, or as events from outside. */
    public List<Wiring.Reader> registers() {
        return registers;
    }

    /** Who gets what is put on a signal, in this order. */
    public List<Wiring.Reader> readers(int signal) {
        return wiring.readers.get(signal);
    }

    /** Whether a reader stores messages; else they are events for it. */
    public boolean isLatched(Wiring.Reader reader) {
        return wiring.port(reader).latched();
    }

    /** Whether the outside sees what is on a signal. */
    public boolean isObserved(int signal) {
        return wiring.observed[signal];
    }

    /** How many events may wait for the part that reads. */
    public int capacity(Wiring.Reader reader) {
        return network.instances().get(reader.part()).component().queueCapacity();
    }

    /** In words, that one more event cannot wait. */
    public String noRoom(Wiring.Reader reader) {
        Port port = wiring.port(reader);
        return "%s has no room for another event on '%s' (capacity %d)"
                .formatted(path(reader.part()), port.name(), capacity(reader));
    }

    /** In words, what goes wrong in a part. */
    public String problem(int part, JointError error) {
        return path(part) + ": " + error.message();
    }

    String path(int part) {
        return network.instances().get(part).path();
    }

    /**
     * How external inputs are looked at, before any part does. An event is seen at least; all of it
     * matters where it is stored or passes through.
     */
    public List<PortAbstraction> firstLooks() {
        List<PortAbstraction> looks = new ArrayList<>();
        for (Network.External input : network.inputs()) {
            boolean stored = readers(input.signal()).stream().anyMatch(this::isLatched);
            if (input.port().latched()) {
                looks.add(new InputAbstraction.Unseen());
            } else {
                looks.add(
                        stored || isShown(network, input)
                                ? new InputAbstraction.Copied()
                                : new InputAbstraction.Compared(List.of(), false));
            }
        }
        return looks;
    }

    static boolean isShown(Network network, Network.External input) {
        return network.outputs().stream().anyMatch(output -> output.signal() == input.signal());
    }
}
