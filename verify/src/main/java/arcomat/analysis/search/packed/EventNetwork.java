package arcomat.analysis.search.packed;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.composition.EventWiring;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.analysis.search.composition.OpenMessages;
import arcomat.analysis.search.composition.Wiring;
import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.packed.EventPart.Delivery;
import arcomat.analysis.search.packed.EventPart.Row;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import com.carrotsearch.hppc.IntArrayList;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * An event-driven network in numbers. Between two events all queues are empty: a configuration is
 * one of each part, and what latched ports hold.
 *
 * <p>The fields of a configuration are those of the parts, each followed by one for what its
 * latched ports hold that are fed from inside or by events; which latched ports of the whole hold
 * something; what ended the run; and the mark.
 */
public final class EventNetwork extends PackedNetwork {
    final List<EventPart> parts = new ArrayList<>();
    final ExternalLooks looks = new ExternalLooks();
    final EventDeliveries deliveries;
    final EventLetters letters;
    final int heldField;
    final int problemField;

    /** How inputs are looked at before any part does. */
    final int firstLooks;

    private final Network network;
    private final EventWiring wiring;
    private final LatchedPorts driven;
    private final Budget budget;
    private final OpenMessages open;
    private final List<List<Integer>> alike;
    private final Numbering<String> problems = new Numbering<>();

    /**
     * @param behaviours one per instance
     * @param compared names of the outputs that the outside looks at
     * @param driven latched inputs that never lose what they hold
     */
    public EventNetwork(
            Network network,
            List<ComponentSemantics> behaviours,
            List<String> compared,
            LatchedPorts driven,
            Budget budget) {
        if (behaviours.isEmpty()) {
            throw new CannotPack("no parts");
        }
        if (driven.positions().size() >= Integer.SIZE - 1) {
            throw new CannotPack("too many latched inputs");
        }
        this.network = network;
        this.budget = budget;
        this.driven = driven;
        wiring = new EventWiring(network, compared);
        open = new OpenMessages(network, wiring, budget, EventNetwork::refuse);
        alike = alike(network);
        deliveries = new EventDeliveries(network, wiring, open, parts);
        for (int part = 0; part < behaviours.size(); part++) {
            List<Numbering<Sent>> read = deliveries.read(part);
            parts.add(new EventPart(behaviours.get(part), part, wiring, read, this::compute));
        }
        letters = new EventLetters(network, wiring, deliveries, parts, driven, this::compute);
        heldField = 2 * parts.size();
        problemField = heldField + 1;
        parts.get(0).number(ENDED);
        firstLooks = looks.number(wiring.firstLooks());
    }

    private static void refuse(String reason) {
        throw new CannotPack(reason);
    }

    private void compute() {
        compute(budget::insist);
    }

    @Override
    public int[] met() {
        return IntStream.concat(
                        IntStream.of(problems.size()),
                        parts.stream()
                                .flatMapToInt(p -> IntStream.of(p.size(), p.registers.size())))
                .toArray();
    }

    @Override
    Object thing(int kind, int number) {
        if (kind == 0) {
            return problems.get(number);
        }
        EventPart part = parts.get((kind - 1) / 2);
        return kind % 2 == 1 ? part.configuration(number) : part.held(number);
    }

    /**
     * A part gets as many bits as others of its kind, since it will need them sooner or later.
     * Those that are the same by accident do no harm.
     */
    @Override
    public PackedLayout layout() {
        int[] widths = new int[markField() + 1];
        for (int part = 0; part < parts.size(); part++) {
            for (int other : alike.get(part)) {
                EventPart each = parts.get(other);
                widths[2 * part] = Math.max(widths[2 * part], bits(each.size()));
                widths[2 * part + 1] = Math.max(widths[2 * part + 1], bits(each.registers.size()));
            }
        }
        widths[heldField] = driven.positions().size();
        widths[problemField] = bits(problems.size());
        widths[markField()] = markBits();
        return PackedLayout.of(widths);
    }

    @Override
    public int markField() {
        return problemField + 1;
    }

    @Override
    public PackedSteps steps(PackedLayout layout) {
        return new PackedEvents(this, layout);
    }

    @Override
    public void pack(GlobalState state, PackedLayout layout, long[] into) {
        Arrays.fill(into, 0);
        if (state.isError()) {
            put(layout, into, problemField, problem(state.problem()));
        } else {
            packParts(state, layout, into);
        }
        if (isDriven()) {
            Sent last = state.registers().get(state.registers().size() - 1);
            Value held = ((Sent.Messages) last).values().get(0);
            put(layout, into, heldField, (int) ((Value.IntegerValue) held).value());
        }
    }

    private void packParts(GlobalState state, PackedLayout layout, long[] into) {
        int register = 0;
        for (int number = 0; number < parts.size(); number++) {
            EventPart part = parts.get(number);
            put(layout, into, 2 * number, part.number(state.parts().get(number)));
            int[] held = new int[part.registerPorts.length];
            for (int i = 0; i < held.length; i++) {
                Sent sent = state.registers().get(register++);
                held[i] =
                        sent.equals(Sent.SILENCE)
                                ? HeldMessages.NONE
                                : deliveries.message(number, part.registerPorts[i], sent);
            }
            put(layout, into, 2 * number + 1, part.registers.number(held));
        }
    }

    private boolean isDriven() {
        return !driven.positions().isEmpty();
    }

    @Override
    public GlobalState unpack(long[] from, PackedLayout layout) {
        List<List<Configuration>> configurations = new ArrayList<>();
        List<Sent> registers = new ArrayList<>();
        boolean ended = hasEnded(from, layout);
        for (int part = 0; part < parts.size() && !ended; part++) {
            configurations.add(parts.get(part).configuration(layout.get(from, 2 * part)));
            registers.addAll(parts.get(part).held(layout.get(from, 2 * part + 1)));
        }
        if (isDriven()) {
            registers.add(Sent.of(new Value.IntegerValue(layout.get(from, heldField))));
        }
        return ended
                ? new GlobalState(
                        List.of(ENDED), registers, problems.get(layout.get(from, problemField)))
                : new GlobalState(configurations, registers);
    }

    @Override
    public boolean hasEnded(long[] from, PackedLayout layout) {
        return layout.get(from, 0) == 0;
    }

    /** The number of what ends a run. */
    int problem(String text) {
        int before = problems.size();
        int number = problems.number(text);
        if (number == before) {
            compute();
        }
        return number;
    }

    /** The number of that one more event cannot wait. */
    int noRoom(int part, int event) {
        return problem(wiring.noRoom(new Wiring.Reader(part, parts.get(part).event(event).port())));
    }

    @Override
    public int[] letter(Value[] letter) {
        return new int[] {letters.number(letter)};
    }

    /** The letters that are told apart where inputs are looked at like this. */
    int[] letters(int look) {
        return letters.of(look, looks.get(look));
    }

    /** What a part may do when it takes an event. */
    Row row(int number, int configuration, int event, int held, int outside) {
        EventPart part = parts.get(number);
        Row row = part.find(configuration, event, held, outside);
        if (row == null) {
            compute();
            row = computed(number, configuration, event, part.messages(event, held, outside));
            part.add(configuration, event, held, outside, row);
        }
        return row;
    }

    private Row computed(int number, int configuration, int event, @Nullable Value[] read) {
        EventPart part = parts.get(number);
        List<Configuration> before = part.configuration(configuration);
        Prospect prospect = part.behaviour.prospect(before, Input.of(read), budget::insist);
        int[] ends =
                prospect.errors().stream()
                        .mapToInt(error -> problem(wiring.problem(number, error)))
                        .toArray();
        IntArrayList next = new IntArrayList();
        List<Delivery[]> sent = new ArrayList<>();
        for (JointReaction reaction : prospect.reactions()) {
            for (List<Sent> settled : open.settled(number, reaction.output().ports())) {
                next.add(part.number(reaction.next()));
                sent.add(deliveries.all(number, settled));
            }
        }
        int look = look(number, before, part.event(event).port());
        return new Row(look, ends, next.toArray(), sent.toArray(Delivery[][]::new));
    }

    /** Only messages from outside are looked at: those from inside are known. */
    private int look(int number, List<Configuration> configuration, int event) {
        List<PortAbstraction> looks =
                new ArrayList<>(InputAbstraction.none(network.inputs().size()).looks());
        List<PortAbstraction> own = parts.get(number).behaviour.abstraction(configuration).looks();
        boolean any = false;
        for (int port = 0; port < own.size(); port++) {
            int origin = port == event ? external(number, port) : wiring.held(number, port);
            if (origin != EventWiring.INSIDE) {
                looks.set(origin, looks.get(origin).and(own.get(port)));
                any = true;
            }
        }
        return any ? this.looks.number(looks) : -1;
    }

    /** The input that a port is connected to. */
    private int external(int part, int port) {
        int signal = network.instances().get(part).inputSignals().get(port);
        for (int input = 0; input < network.inputs().size(); input++) {
            if (network.inputs().get(input).signal() == signal) {
                return input;
            }
        }
        return EventWiring.INSIDE;
    }
}
