package arcomat.analysis.search.packed;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.composition.EventWiring;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import com.carrotsearch.hppc.LongIntHashMap;
import com.carrotsearch.hppc.LongObjectHashMap;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A part that takes events, in numbers: its configurations, its events, and what its latched ports
 * hold. What it does is asked once for each configuration, event, and what is held then.
 */
final class EventPart {
    /**
     * A message for a port.
     *
     * @param message its number on the signal
     */
    record Event(int port, int message) {}

    /**
     * What becomes of a message on a signal.
     *
     * @param shown what the outside sees, as {@link ShownSequences} has it; -1 for nothing
     * @param latches readers that store it: part, position of the register, and message
     * @param events readers that it is an event for: part and number of the event
     */
    record Delivery(int shown, int[] latches, int[] events) {
        /** Whether nobody notices. */
        boolean isNothing() {
            return shown < 0 && latches.length == 0 && events.length == 0;
        }
    }

    /**
     * What the part may do.
     *
     * @param look how that looks at what comes from outside; -1 for not at all
     * @param problems with which the run ends, by number
     * @param next the configuration afterwards, way by way
     * @param sent in order, way by way
     */
    record Row(int look, int[] problems, int[] next, Delivery[][] sent) {}

    /** Numbers of inputs up to here have places, others are looked for. */
    private static final int FEW = 64;

    private static final int BITS = 21;

    final ComponentSemantics behaviour;
    final int capacity;

    /** Of ports whose messages come from inside, or as events from outside. */
    final HeldMessages registers;

    /** Of ports whose messages latched inputs from outside hold. */
    final HeldMessages outside;

    /** The ports of both. */
    final int[] registerPorts;

    final int[] outsidePorts;

    private final List<Numbering<Sent>> inputs;
    private final Numbering<List<Configuration>> configurations = new Numbering<>();
    private final Numbering<Event> events = new Numbering<>();
    private final LongIntHashMap reading = new LongIntHashMap();
    private final List<@Nullable Row[]> few = new ArrayList<>();
    private final LongObjectHashMap<Row> many = new LongObjectHashMap<>();

    /**
     * @param inputs what is on each input port, in numbers
     * @param compute called before something new gets a number
     */
    EventPart(
            ComponentSemantics behaviour,
            int part,
            EventWiring wiring,
            List<Numbering<Sent>> inputs,
            Runnable compute) {
        this.behaviour = behaviour;
        this.inputs = inputs;
        this.capacity = behaviour.component().queueCapacity();
        registerPorts =
                wiring.registers().stream()
                        .filter(register -> register.part() == part)
                        .mapToInt(register -> register.port())
                        .toArray();
        List<Port> ports = behaviour.component().inputs();
        outsidePorts =
                IntStream.range(0, ports.size())
                        .filter(port -> wiring.held(part, port) != EventWiring.INSIDE)
                        .toArray();
        registers = new HeldMessages(registerPorts.length, compute);
        outside = new HeldMessages(outsidePorts.length, compute);
    }

    /** The number of a configuration; they are numbered as they come. */
    int number(List<Configuration> configuration) {
        return configurations.number(configuration);
    }

    List<Configuration> configuration(int number) {
        return configurations.get(number);
    }

    /** How many configurations have been met. */
    int size() {
        return configurations.size();
    }

    int number(Event event) {
        return events.number(event);
    }

    Event event(int number) {
        return events.get(number);
    }

    /** Where a message is stored that a latched port gets. */
    int register(int port) {
        return Arrays.binarySearch(registerPorts, port);
    }

    /** What has been asked before; null where it has not. */
    @Nullable Row find(int configuration, int event, int held, int outside) {
        int input = input(event, held, outside);
        if (input >= FEW) {
            return many.get(key(configuration, input));
        }
        Row[] rows = configuration < few.size() ? few.get(configuration) : null;
        return rows == null || input >= rows.length ? null : rows[input];
    }

    void add(int configuration, int event, int held, int outside, Row row) {
        int input = input(event, held, outside);
        if (input >= FEW) {
            many.put(key(configuration, input), row);
            return;
        }
        while (few.size() <= configuration) {
            few.add(new Row[0]);
        }
        Row[] rows = few.get(configuration);
        if (input >= rows.length) {
            rows = Arrays.copyOf(rows, input + 1);
            few.set(configuration, rows);
        }
        rows[input] = row;
    }

    private static long key(int configuration, int input) {
        return (long) configuration << 32 | input;
    }

    /** All that is read at once, as one number. */
    private int input(int event, int held, int outside) {
        if (registerPorts.length == 0 && outsidePorts.length == 0) {
            return event;
        }
        if ((event | held | outside) >>> BITS != 0) {
            throw new CannotPack("a part reads too much");
        }
        long key = ((long) event << BITS | held) << BITS | outside;
        int slot = reading.indexOf(key);
        if (reading.indexExists(slot)) {
            return reading.indexGet(slot);
        }
        int number = reading.size();
        reading.indexInsert(slot, key, number);
        return number;
    }

    /** What is read, by input port. */
    @Nullable Value[] messages(int event, int held, int outside) {
        @Nullable Value[] messages = new Value[inputs.size()];
        for (int i = 0; i < registerPorts.length; i++) {
            messages[registerPorts[i]] = value(registerPorts[i], registers.message(held, i));
        }
        for (int i = 0; i < outsidePorts.length; i++) {
            messages[outsidePorts[i]] = value(outsidePorts[i], this.outside.message(outside, i));
        }
        Event taken = events.get(event);
        messages[taken.port] = value(taken.port, taken.message);
        return messages;
    }

    private @Nullable Value value(int port, int message) {
        return message == HeldMessages.NONE
                ? null
                : ((Sent.Messages) inputs.get(port).get(message)).values().get(0);
    }

    /** What registers hold, port by port. */
    List<Sent> held(int held) {
        return IntStream.range(0, registerPorts.length)
                .mapToObj(i -> Sent.of(value(registerPorts[i], registers.message(held, i))))
                .toList();
    }
}
