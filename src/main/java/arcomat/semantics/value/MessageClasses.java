package arcomat.semantics.value;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Unseen;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The kinds of messages that a look at a port tells apart: none, each value that it is compared
 * with, and those between or beside them. A sample stands for all messages of its kind.
 *
 * <p>Kind 0 is silence, kind 2k + 2 the k-th value, kind 2k + 1 what lies before it; 1 is anything
 * else where order does not matter. Where it does, the last kind is what has no place in it, NaN.
 */
public final class MessageClasses {
    private final List<Value> values;
    private final boolean ordered;
    private final boolean seen;
    private final List<Value> samples = new ArrayList<>();
    private final int count;

    /** What is neither less nor greater than any number, nor equal to one. */
    private static final Value NOT_A_NUMBER = new Value.RealValue(Double.NaN);

    private MessageClasses(
            Port port, boolean total, List<Value> values, boolean ordered, boolean closed) {
        this.values = values;
        this.ordered = ordered;
        this.seen = true;
        boolean unordered = ordered && !values.isEmpty() && port.type() instanceof Type.RealType;
        this.count = 2 * values.size() + (unordered ? 3 : 2);
        if (!total) {
            samples.add(null);
        }
        List<Value> possible = values.stream().filter(v -> isIn(port.type(), v)).toList();
        samples.addAll(possible);
        if (!closed) {
            ValueGaps beside = new ValueGaps(port.type(), possible);
            samples.addAll(ordered ? beside.gaps() : beside.any());
        }
        if (unordered) {
            samples.add(NOT_A_NUMBER);
        }
    }

    private MessageClasses(Port port, boolean total) {
        this.values = List.of();
        this.ordered = false;
        this.seen = false;
        this.count = 1;
        samples.add(total ? port.type().first() : null);
    }

    /**
     * @param total whether there is always a message
     * @throws TooManyMessages where all values matter and there are too many to try
     */
    public static MessageClasses of(Port port, boolean total, PortAbstraction look) {
        if (look instanceof Unseen) {
            return new MessageClasses(port, total);
        }
        if (look instanceof Compared compared) {
            return new MessageClasses(port, total, compared.values(), compared.ordered(), false);
        }
        List<Value> all = SmallType.values(port.type()).orElseThrow(() -> TooManyMessages.on(port));
        return new MessageClasses(port, total, all, false, true);
    }

    /** A port may be compared with a variable that is outside of the port's range. */
    public static boolean isIn(Type type, Value value) {
        if (type instanceof Type.IntegerType integer) {
            long number = ((Value.IntegerValue) value).value();
            return integer.low() <= number && number <= integer.high();
        }
        return true;
    }

    /** One message of each kind; null is silence. */
    public List<Value> samples() {
        return samples;
    }

    /** A bound for the numbers of kinds. */
    public int count() {
        return count;
    }

    /** To a comparison there is only one zero. */
    private static Value compared(Value message) {
        return message instanceof Value.RealValue real && real.value() == 0
                ? new Value.RealValue(0)
                : message;
    }

    /** The kind of a message; null is silence. */
    public int of(@Nullable Value message) {
        if (!seen || message == null) {
            return 0;
        }
        if (ordered && message.equals(NOT_A_NUMBER)) {
            return count - 1;
        }
        int found = Collections.binarySearch(values, compared(message));
        if (found >= 0) {
            return 2 * found + 2;
        }
        return ordered ? 2 * (-found - 1) + 1 : 1;
    }
}
