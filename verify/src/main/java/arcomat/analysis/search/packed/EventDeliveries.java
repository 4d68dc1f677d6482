package arcomat.analysis.search.packed;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.composition.EventWiring;
import arcomat.analysis.search.composition.OpenMessages;
import arcomat.analysis.search.composition.Wiring;
import arcomat.analysis.search.packed.EventPart.Delivery;
import arcomat.analysis.search.packed.EventPart.Event;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.List;

/**
 * What becomes of messages on the signals of an event-driven network: each of them, in numbers,
 * goes to the same registers and queues each time.
 */
final class EventDeliveries {
    final ShownSequences shown = new ShownSequences();

    private final Network network;
    private final EventWiring wiring;
    private final OpenMessages open;
    private final List<EventPart> parts;

    /** By signal. */
    private final List<Numbering<Sent>> messages = new ArrayList<>();

    private final List<List<Delivery>> deliveries = new ArrayList<>();

    /**
     * @param parts those of the network, as soon as they are there
     */
    EventDeliveries(Network network, EventWiring wiring, OpenMessages open, List<EventPart> parts) {
        this.network = network;
        this.wiring = wiring;
        this.open = open;
        this.parts = parts;
        for (int signal = 0; signal < network.signals(); signal++) {
            messages.add(new Numbering<>());
            deliveries.add(new ArrayList<>());
        }
    }

    /** What is shown on a signal, as one. */
    Sent shown(int sequence, int signal) {
        Network.External output =
                network.outputs().stream()
                        .filter(each -> each.signal() == signal)
                        .findFirst()
                        .orElseThrow();
        return open.joined(output, shown.on(signal, sequence));
    }

    /** By input port of a part, what may come there in numbers. */
    List<Numbering<Sent>> read(int part) {
        return network.instances().get(part).inputSignals().stream()
                .map(signal -> signal < 0 ? new Numbering<Sent>() : messages.get(signal))
                .toList();
    }

    /** The number of a message for an input port of a part. */
    int message(int part, int port, Sent sent) {
        int signal = network.instances().get(part).inputSignals().get(port);
        return messages.get(signal).number(sent);
    }

    /** All that a part sends with a reaction, in order. */
    Delivery[] all(int part, List<Sent> sent) {
        List<Integer> signals = network.instances().get(part).outputSignals();
        List<Delivery> all = new ArrayList<>();
        for (int port = 0; port < signals.size(); port++) {
            int signal = signals.get(port);
            if (sent.get(port) instanceof Sent.Messages several) {
                several.values().forEach(each -> all.add(one(signal, Sent.of(each))));
            } else {
                all.add(one(signal, sent.get(port)));
            }
        }
        all.removeIf(Delivery::isNothing);
        return all.toArray(Delivery[]::new);
    }

    Delivery one(int signal, Sent sent) {
        int message = messages.get(signal).number(sent);
        List<Delivery> known = deliveries.get(signal);
        while (known.size() <= message) {
            known.add(made(signal, known.size()));
        }
        return known.get(message);
    }

    private Delivery made(int signal, int message) {
        Sent sent = messages.get(signal).get(message);
        int thing = wiring.isObserved(signal) ? shown.thing(signal, sent) : -1;
        IntArrayList latches = new IntArrayList();
        IntArrayList events = new IntArrayList();
        if (sent instanceof Sent.Messages) {
            for (Wiring.Reader reader : wiring.readers(signal)) {
                EventPart part = parts.get(reader.part());
                if (wiring.isLatched(reader)) {
                    latches.add(reader.part(), part.register(reader.port()), message);
                } else {
                    events.add(reader.part(), part.number(new Event(reader.port(), message)));
                }
            }
        }
        return new Delivery(thing, latches.toArray(), events.toArray());
    }
}
