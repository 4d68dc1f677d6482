package arcomat.simulate.test;

import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.simulate.test.AllowedBehaviour.Standing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** A run of an event-driven network, in the middle of an event or between two. */
final class PossibleRun {
    /** A message that waits. */
    record Event(int port, Value message) {}

    final List<List<Configuration>> configurations;
    private final List<List<Event>> queues;

    /** By instance and port, null before the first message. */
    private final Value[][] latched;

    /** By expected stream, how many of its messages have been seen. */
    final int[] seen;

    /** The instance that is asked next whether an event waits for it. */
    private int turn;

    Standing standing = Standing.SURE;

    /** The event since which it stands for no more than it does. */
    int since;

    /** The first instance that allows something only because it is in chaos; -1 if none does. */
    int chaotic = -1;

    /**
     * @param ports how many inputs each instance has
     * @param streams how many are expected
     */
    PossibleRun(int[] ports, int streams) {
        configurations = new ArrayList<>();
        queues = new ArrayList<>();
        latched = new Value[ports.length][];
        seen = new int[streams];
        for (int i = 0; i < ports.length; i++) {
            queues.add(List.of());
            latched[i] = new Value[ports[i]];
        }
    }

    private PossibleRun(PossibleRun other) {
        configurations = new ArrayList<>(other.configurations);
        queues = new ArrayList<>(other.queues);
        latched = other.latched.clone();
        seen = other.seen.clone();
        turn = other.turn;
        standing = other.standing;
        since = other.since;
        chaotic = other.chaotic;
    }

    PossibleRun copy() {
        return new PossibleRun(this);
    }

    void latch(int instance, int port, Value message) {
        latched[instance] = latched[instance].clone();
        latched[instance][port] = message;
    }

    void enqueue(int instance, Event event) {
        List<Event> longer = new ArrayList<>(queues.get(instance));
        longer.add(event);
        queues.set(instance, longer);
    }

    int waiting(int instance) {
        return queues.get(instance).size();
    }

    /** Whether all that an event has caused is worked off. */
    boolean isQuiet() {
        return queues.stream().allMatch(List::isEmpty);
    }

    /** The next instance, in turn, for which an event waits. */
    int next() {
        int instance = turn;
        while (queues.get(instance).isEmpty()) {
            instance = (instance + 1) % queues.size();
        }
        return instance;
    }

    /** Takes the first event of an instance: what that reads, port by port. */
    Value[] take(int instance) {
        List<Event> queue = queues.get(instance);
        Value[] messages = latched[instance].clone();
        messages[queue.get(0).port()] = queue.get(0).message();
        queues.set(instance, queue.subList(1, queue.size()));
        turn = (instance + 1) % queues.size();
        return messages;
    }

    /** Events come when all is quiet, and are worked off from the first instance on. */
    void begin() {
        turn = 0;
    }

    /** All that matters for the rest of the run. */
    List<Object> state() {
        return List.of(
                List.copyOf(configurations),
                List.copyOf(queues),
                Arrays.asList(latched).stream().map(Arrays::asList).toList(),
                Arrays.stream(seen).boxed().toList(),
                turn);
    }

    /** Whether it tells more than another one that goes on alike. */
    boolean isBetterThan(PossibleRun other) {
        return standing.isBetterThan(other.standing)
                || standing == other.standing && since > other.since;
    }

    /** It stands for no more than that from an event on. */
    void lower(Standing other, int event) {
        if (standing.isBetterThan(other)) {
            standing = other;
            since = event;
        }
    }
}
