package arcomat.analysis.search.packed;

import arcomat.analysis.search.Numbering;
import arcomat.analysis.search.composition.EventWiring;
import arcomat.analysis.search.letter.LatchedPorts;
import arcomat.analysis.search.letter.Representatives;
import arcomat.analysis.search.packed.EventPart.Delivery;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;
import arcomat.model.Component.Profile;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.TooManyMessages;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Events from outside, with what latched inputs hold then, in numbers. */
final class EventLetters {
    /**
     * What an input does.
     *
     * @param outside by part what its ports read that latched inputs feed
     * @param held which latched inputs hold something, as {@link LatchedPorts} has it
     */
    record Letter(Delivery event, int[] outside, int held) {}

    private final Network network;
    private final EventWiring wiring;
    private final EventDeliveries deliveries;
    private final List<EventPart> parts;
    private final LatchedPorts driven;
    private final Runnable compute;
    private final List<Port> inputs;
    private final Numbering<List<@Nullable Value>> numbers = new Numbering<>();
    private final List<Letter> letters = new ArrayList<>();
    private final List<int[]> ofLooks = new ArrayList<>();

    /**
     * @param driven latched inputs that never lose what they hold
     * @param compute called before something new is made
     */
    EventLetters(
            Network network,
            EventWiring wiring,
            EventDeliveries deliveries,
            List<EventPart> parts,
            LatchedPorts driven,
            Runnable compute) {
        this.network = network;
        this.wiring = wiring;
        this.deliveries = deliveries;
        this.parts = parts;
        this.driven = driven;
        this.compute = compute;
        this.inputs = network.inputs().stream().map(Network.External::port).toList();
    }

    Letter get(int number) {
        return letters.get(number);
    }

    /**
     * @param messages by position of the external input
     */
    int number(Value[] messages) {
        int number = numbers.number(Arrays.asList(messages.clone()));
        if (number == letters.size()) {
            letters.add(letter(messages));
        }
        return number;
    }

    /**
     * The letters that are told apart where inputs are looked at in a certain way.
     *
     * @param look a number for that way
     */
    int[] of(int look, List<PortAbstraction> looks) {
        while (ofLooks.size() <= look) {
            ofLooks.add(new int[0]);
        }
        if (ofLooks.get(look).length == 0) {
            compute.run();
            ofLooks.set(look, all(looks).stream().mapToInt(this::number).toArray());
        }
        return ofLooks.get(look);
    }

    private List<Value[]> all(List<PortAbstraction> looks) {
        try {
            return Representatives.NONE.letters(Profile.EVENT_DRIVEN, inputs, looks);
        } catch (TooManyMessages tooMany) {
            throw new CannotPack("there are too many inputs");
        }
    }

    private Letter letter(Value[] messages) {
        int[] outside = new int[parts.size()];
        for (int part = 0; part < outside.length; part++) {
            outside[part] = outside(part, messages);
        }
        for (int input = 0; input < messages.length; input++) {
            if (messages[input] != null && !inputs.get(input).latched()) {
                int signal = network.inputs().get(input).signal();
                Delivery event = deliveries.one(signal, Sent.of(messages[input]));
                return new Letter(event, outside, (int) driven.held(messages));
            }
        }
        throw new CannotPack("an event is none for any input");
    }

    private int outside(int number, Value[] messages) {
        EventPart part = parts.get(number);
        int[] held = new int[part.outsidePorts.length];
        for (int i = 0; i < held.length; i++) {
            int port = part.outsidePorts[i];
            Value message = messages[wiring.held(number, port)];
            held[i] =
                    message == null
                            ? HeldMessages.NONE
                            : deliveries.message(number, port, Sent.of(message));
        }
        return part.outside.number(held);
    }
}
