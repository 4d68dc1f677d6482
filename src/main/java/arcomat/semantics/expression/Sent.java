package arcomat.semantics.expression;

import arcomat.model.Value;

import org.jspecify.annotations.Nullable;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** What a step says about one output port: messages, or that they are left open. */
public sealed interface Sent {
    /** No message. */
    Sent SILENCE = new Messages(List.of());

    /** One message, or none where it is null. */
    static Sent of(@Nullable Value message) {
        return message == null ? SILENCE : new Messages(List.of(message));
    }

    /** These messages in order; none is silence, time-synchronous there is at most one. */
    record Messages(List<Value> values) implements Sent {
        public Messages {
            values = List.copyOf(values);
        }

        @Override
        public String toString() {
            return values.isEmpty()
                    ? "--"
                    : values.stream().map(Value::toString).collect(Collectors.joining(", "));
        }
    }

    /** Some message, whichever. */
    record AnyMessage() implements Sent {
        @Override
        public String toString() {
            return "?";
        }
    }

    /** Any message or none. */
    record Anything() implements Sent {
        @Override
        public String toString() {
            return "anything";
        }
    }

    /** Whether exactly these messages are among what is left open. */
    default boolean allows(List<Value> values) {
        if (this instanceof Messages messages) {
            return messages.values.equals(values);
        }
        return this instanceof Anything || values.size() == 1;
    }

    /** What both allow; empty if that is nothing. */
    default Optional<Sent> meet(Sent other) {
        if (this instanceof Anything || equals(other)) {
            return Optional.of(other);
        }
        if (other instanceof Anything) {
            return Optional.of(this);
        }
        if (this instanceof Messages messages) {
            return other.allows(messages.values) ? Optional.of(this) : Optional.empty();
        }
        return other.meet(this);
    }
}
