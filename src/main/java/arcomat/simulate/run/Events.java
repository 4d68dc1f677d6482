package arcomat.simulate.run;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Execution;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The event-driven engine: queues, latches, run to completion as {@link Network} describes it. */
public final class Events implements Interpreter.Engine {
    private record Event(int port, Value message) {}

    private record Receiver(Mailbox mailbox, int port, boolean latched) {}

    /** What waits for an instance, and what it has latched. */
    private static final class Mailbox {
        final Actor actor;
        final Deque<Event> queue = new ArrayDeque<>();
        final Value[] latched;

        Mailbox(Actor actor) {
            this.actor = actor;
            this.latched = new Value[actor.instance().inputSignals().size()];
        }
    }

    private final Network network;
    private final Surroundings surroundings;
    private final List<Network.External> heard;
    private final List<Mailbox> mailboxes = new ArrayList<>();
    private final List<List<Receiver>> receivers = new ArrayList<>();
    private final List<List<String>> shown = new ArrayList<>();
    private final List<List<String>> told = new ArrayList<>();
    private Map<String, List<Value>> outputs = new LinkedHashMap<>();
    private Map<String, List<Value>> between = new LinkedHashMap<>();
    private boolean started;
    private Optional<Letter> opening = Optional.empty();

    /**
     * @param heard ports of parts that are told of
     */
    Events(Network network, List<Actor> actors, List<Network.External> heard) {
        this.network = network;
        this.surroundings = new Surroundings(network);
        this.heard = heard;
        for (int i = 0; i < network.signals(); i++) {
            receivers.add(new ArrayList<>(1));
            shown.add(new ArrayList<>(1));
            told.add(new ArrayList<>(0));
        }
        for (Actor actor : actors) {
            Mailbox mailbox = new Mailbox(actor);
            mailboxes.add(mailbox);
            List<Port> ports = actor.instance().component().inputs();
            for (int i = 0; i < ports.size(); i++) {
                int signal = actor.instance().inputSignals().get(i);
                if (signal != Network.UNCONNECTED) {
                    receivers.get(signal).add(new Receiver(mailbox, i, ports.get(i).latched()));
                }
            }
        }
        name(network.outputs(), shown);
        name(heard, told);
    }

    private static void name(List<Network.External> ports, List<List<String>> bySignal) {
        for (Network.External external : ports) {
            if (external.signal() != Network.UNCONNECTED) {
                bySignal.get(external.signal()).add(external.name());
            }
        }
    }

    @Override
    public Trace.Step step(Letter input, int number) {
        outputs = silent(network.outputs());
        between = silent(heard);
        List<Trace.Activity> activities = new ArrayList<>();
        if (!started) {
            started = true;
            mailboxes.forEach(mailbox -> send(mailbox, mailbox.actor.start()));
            runToCompletion(number, activities);
            opening = Optional.of(new Letter(outputs));
        }
        surroundings.requireKnownPorts(input);
        for (Network.External external : network.inputs()) {
            input.messages(external.name()).forEach(message -> send(external.signal(), message));
        }
        runToCompletion(number, activities);
        return new Trace.Step(number, input, new Letter(outputs), activities, new Letter(between));
    }

    private static Map<String, List<Value>> silent(List<Network.External> ports) {
        Map<String, List<Value>> silence = new LinkedHashMap<>();
        ports.forEach(external -> silence.put(external.name(), new ArrayList<>()));
        return silence;
    }

    @Override
    public Optional<Letter> opening() {
        return opening;
    }

    /** After an event that goes wrong, nothing is shown. */
    @Override
    public Trace.End end(Letter input) {
        return new Trace.End(input, Letter.SILENCE);
    }

    private void runToCompletion(int number, List<Trace.Activity> activities) {
        int reactions = 0;
        boolean worked = true;
        while (worked) {
            worked = false;
            for (Mailbox mailbox : mailboxes) {
                Event event = mailbox.queue.poll();
                if (event != null) {
                    worked = true;
                    react(mailbox, event, number, activities);
                    reactions++;
                }
            }
            if (reactions > Execution.MOST_REACTIONS) {
                throw Execution.circling();
            }
        }
    }

    private void react(Mailbox mailbox, Event event, int number, List<Trace.Activity> activities) {
        Value[] messages = mailbox.latched.clone();
        messages[event.port] = event.message;
        send(mailbox, mailbox.actor.react(Input.of(messages), number, activities));
    }

    private void send(Mailbox sender, List<List<Value>> messages) {
        for (int i = 0; i < messages.size(); i++) {
            int signal = sender.actor.instance().outputSignals().get(i);
            messages.get(i).forEach(message -> send(signal, message));
        }
    }

    @SuppressWarnings("NullAway") // each name that is shown has its list
    private void send(int signal, Value message) {
        shown.get(signal).forEach(name -> outputs.get(name).add(message));
        told.get(signal).forEach(name -> between.get(name).add(message));
        for (Receiver receiver : receivers.get(signal)) {
            if (receiver.latched) {
                receiver.mailbox.latched[receiver.port] = message;
            } else {
                enqueue(receiver, message);
            }
        }
    }

    private static void enqueue(Receiver receiver, Value message) {
        Network.Instance instance = receiver.mailbox.actor.instance();
        int capacity = instance.component().queueCapacity();
        if (receiver.mailbox.queue.size() >= capacity) {
            throw fullQueue(instance, instance.component().inputs().get(receiver.port).name());
        }
        receiver.mailbox.queue.add(new Event(receiver.port, message));
    }

    public static ModelError fullQueue(Network.Instance instance, String port) {
        return Actor.at(
                instance,
                new ModelError(
                        "the queue is full: "
                                + instance.component().queueCapacity()
                                + " events wait, another on "
                                + port
                                + " does not fit"));
    }
}
