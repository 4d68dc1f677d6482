package arcomat.pipeline.inside;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Any number of messages in a step. What parts send is told when they send it. What comes from
 * outside is told when the first part handles it, or, where it is only latched, when the first part
 * reads another value than before.
 */
final class EventSignals implements Signals {
    /** Signals from outside that are an event to somebody. */
    private final Set<Integer> triggering = new HashSet<>();

    private final Set<Integer> outside = new HashSet<>();
    private final Map<Integer, List<Value>> carried = new HashMap<>();

    /** How many messages of a signal have been told. */
    private final Map<Integer, Integer> told = new HashMap<>();

    /** How many of them an input has handled. */
    private final Map<Receiver, Integer> handled = new HashMap<>();

    /** What a latched signal was when somebody last read it. */
    private final Map<Integer, Value> latest = new HashMap<>();

    private boolean begun;

    private record Receiver(String part, int port) {}

    EventSignals(Network network) {
        network.inputs().forEach(each -> outside.add(each.signal()));
        for (Network.Instance part : network.instances()) {
            List<Port> ports = part.component().inputs();
            for (int i = 0; i < ports.size(); i++) {
                if (!ports.get(i).latched()) {
                    triggering.add(part.inputSignals().get(i));
                }
            }
        }
    }

    /** What parts send to begin with, before the first step, is a part of that. */
    @Override
    public void next() {
        if (begun) {
            carried.clear();
        }
        begun = true;
    }

    @Override
    public void read(Network.Instance part, Input input) {
        for (int i = 0; i < part.inputSignals().size(); i++) {
            int signal = part.inputSignals().get(i);
            Optional<Value> message = input.message(i);
            if (!outside.contains(signal) || message.isEmpty()) {
                continue;
            }
            Port port = part.component().inputs().get(i);
            if (!port.latched()) {
                handle(signal, new Receiver(part.path(), i), message.get());
            } else if (!triggering.contains(signal)) {
                look(signal, port, message.get());
            }
        }
    }

    private void handle(int signal, Receiver receiver, Value message) {
        int number = handled.merge(receiver, 1, Integer::sum);
        if (number > told.getOrDefault(signal, 0)) {
            told.put(signal, number);
            send(signal, List.of(message));
        }
    }

    private void look(int signal, Port port, Value value) {
        Optional<Value> before = Optional.ofNullable(latest.get(signal)).or(port::first);
        if (!before.equals(Optional.of(value))) {
            latest.put(signal, value);
            send(signal, List.of(value));
        }
    }

    @Override
    public void send(int signal, List<Value> messages) {
        carried.computeIfAbsent(signal, any -> new ArrayList<>()).addAll(messages);
    }

    @Override
    public List<Value> shown(int signal) {
        return List.copyOf(carried.getOrDefault(signal, List.of()));
    }
}
