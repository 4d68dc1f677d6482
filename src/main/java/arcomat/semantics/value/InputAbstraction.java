package arcomat.semantics.value;

import arcomat.model.Value;
import arcomat.semantics.expression.DataSorts;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.TreeSet;

/**
 * What the steps out of a configuration look at, input port by input port. Letters that look alike
 * have the same steps, so that an analysis tries one of each kind instead of all letters.
 *
 * @param looks one per input port, in the order of declaration
 */
public record InputAbstraction(List<PortAbstraction> looks) {
    public InputAbstraction {
        looks = List.copyOf(looks);
    }

    /** Nothing matters. */
    public static InputAbstraction none(int ports) {
        return new InputAbstraction(Collections.nCopies(ports, new Unseen()));
    }

    /** What looks as closely as both, port by port. */
    public InputAbstraction and(InputAbstraction other) {
        List<PortAbstraction> both = new ArrayList<>(looks.size());
        for (int port = 0; port < looks.size(); port++) {
            both.add(looks.get(port).and(other.looks.get(port)));
        }
        return new InputAbstraction(both);
    }

    /** How one port is looked at. */
    public sealed interface PortAbstraction {
        /** What looks as closely as both. */
        default PortAbstraction and(PortAbstraction other) {
            if (this instanceof Unseen || other instanceof Whole) {
                return other;
            }
            if (other instanceof Unseen || this instanceof Whole) {
                return this;
            }
            if (this instanceof Copied || other instanceof Copied) {
                return new Copied();
            }
            Compared one = (Compared) this;
            Compared two = (Compared) other;
            List<Value> values = new ArrayList<>(one.values);
            values.addAll(two.values);
            return new Compared(values, one.ordered || two.ordered);
        }
    }

    /** Message or none, whichever: it is the same. */
    public record Unseen() implements PortAbstraction {}

    /**
     * Whether there is a message, and how it compares with some values.
     *
     * @param values without duplicates, in their natural order
     * @param ordered whether it matters which of the values are less
     */
    public record Compared(List<Value> values, boolean ordered) implements PortAbstraction {
        public Compared {
            TreeSet<Value> sorted = new TreeSet<>(ValueOrder.NATURAL);
            sorted.addAll(values);
            values = List.copyOf(sorted);
        }
    }

    /**
     * Stored, sent on as it is, or compared for equality with another message: every value makes a
     * difference, but perhaps only whether it is the same as others ({@link DataSorts}).
     */
    public record Copied() implements PortAbstraction {}

    /** Every value may make a difference: it is calculated with. */
    public record Whole() implements PortAbstraction {}
}
