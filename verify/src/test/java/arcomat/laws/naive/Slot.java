package arcomat.laws.naive;

import arcomat.model.Port;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * What may be said about one output: just these messages, or that they are left open.
 *
 * @param messages in order; none is silence
 */
record Slot(Kind kind, List<Value> messages) {
    enum Kind {
        JUST,
        ONE_MESSAGE,
        ANYTHING
    }

    static final Slot SILENCE = new Slot(Kind.JUST, List.of());
    private static final Slot ONE = new Slot(Kind.ONE_MESSAGE, List.of());
    private static final Slot ANYTHING = new Slot(Kind.ANYTHING, List.of());

    static Slot just(List<Value> messages) {
        return new Slot(Kind.JUST, messages);
    }

    static Slot of(Value message) {
        return message == null ? SILENCE : just(List.of(message));
    }

    /** Left open; a total port carries some message. */
    static Slot open(Port port) {
        return port.total() ? ONE : ANYTHING;
    }

    static Slot oneMessage() {
        return ONE;
    }

    boolean isOpen() {
        return kind != Kind.JUST;
    }

    boolean allows(List<Value> seen) {
        return switch (kind) {
            case JUST -> messages.equals(seen);
            case ONE_MESSAGE -> seen.size() == 1;
            case ANYTHING -> true;
        };
    }

    /** What both allow. */
    Optional<Slot> and(Slot other) {
        if (!isOpen()) {
            return other.allows(messages) ? Optional.of(this) : Optional.empty();
        }
        if (!other.isOpen()) {
            return other.and(this);
        }
        return Optional.of(kind == Kind.ONE_MESSAGE ? this : other);
    }

    /** Each message that may be there, or none. */
    List<Slot> writtenOut(Port port, List<Value> pool) {
        if (!isOpen()) {
            return List.of(this);
        }
        List<Slot> all = new ArrayList<>();
        if (kind == Kind.ANYTHING) {
            all.add(SILENCE);
        }
        NaiveValues.all(port.type(), pool).forEach(value -> all.add(of(value)));
        return all;
    }

    /** The only message, or null. */
    Value message() {
        return messages.isEmpty() ? null : messages.get(0);
    }
}
