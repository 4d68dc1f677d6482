package arcomat.semantics.automaton;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * What an automaton reads in one step, by position of the input port. Time-synchronous: the letter
 * of the slice. Event-driven: the message of the event and the latched values.
 */
public final class Input {
    private final Value[] messages;

    private Input(Value[] messages) {
        this.messages = messages;
    }

    /**
     * An input that takes the array over.
     *
     * @param messages one per input port, null where there is none; not to be changed afterwards
     */
    public static Input of(Value[] messages) {
        return new Input(messages);
    }

    /** The messages of a letter on the input ports of a component. */
    public static Input of(Component component, Letter letter) {
        List<Port> ports = component.inputs();
        Value[] messages = new Value[ports.size()];
        for (int i = 0; i < messages.length; i++) {
            messages[i] = letter.message(ports.get(i).name()).orElse(null);
        }
        return new Input(messages);
    }

    /**
     * What a part reads, of what is visible in a slice.
     *
     * @param signals one per input port, {@link Network#UNCONNECTED} where there is none
     * @param visible by signal; what is left open is read by nobody
     */
    public static Input of(List<Integer> signals, Sent[] visible) {
        Value[] messages = new Value[signals.size()];
        for (int i = 0; i < messages.length; i++) {
            int signal = signals.get(i);
            if (signal != Network.UNCONNECTED
                    && visible[signal] instanceof Sent.Messages sent
                    && !sent.values().isEmpty()) {
                messages[i] = sent.values().get(0);
            }
        }
        return new Input(messages);
    }

    Value[] slots() {
        return messages;
    }

    /** The message on an input port, by its position. */
    public Optional<Value> message(int port) {
        return Optional.ofNullable(messages[port]);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Input that && Arrays.equals(messages, that.messages);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(messages);
    }
}
