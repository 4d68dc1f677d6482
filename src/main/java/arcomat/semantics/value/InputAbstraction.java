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
        /** How closely: what looks more closely tells apart all that the others do. */
        int closeness();

        /** What looks as closely as both. */
        default PortAbstraction and(PortAbstraction other) {
            return closeness() < other.closeness() ? other : this;
        }
    }

    /** Message or none, whichever: it is the same. */
    public record Unseen() implements PortAbstraction {
        @Override
        public int closeness() {
            return 0;
        }
    }

    /**
     * Whether there is a message, and how it compares with some values.
     *
     * @param values without duplicates, in their natural order
     * @param ordered whether it matters which of the values are less
     */
    public record Compared(List<Value> values, boolean ordered) implements PortAbstraction {
        public Compared {
            TreeSet<Value> sorted = new TreeSet<>();
            sorted.addAll(values);
            values = List.copyOf(sorted);
        }

        @Override
        public int closeness() {
            return 1;
        }

        @Override
        public PortAbstraction and(PortAbstraction other) {
            if (!(other instanceof Compared compared)) {
                return PortAbstraction.super.and(other);
            }
            List<Value> both = new ArrayList<>(values);
            both.addAll(compared.values);
            return new Compared(both, ordered || compared.ordered);
        }
    }

    /**
     * Stored, sent on as it is, or compared for equality with another message: every value makes a
     * difference, but perhaps only whether it is the same as others ({@link DataSorts}).
     */
    public record Copied() implements PortAbstraction {
        @Override
        public int closeness() {
            return 2;
        }
    }

    /** Every value may make a difference: it is calculated with. */
    public record Whole() implements PortAbstraction {
        @Override
        public int closeness() {
            return 3;
        }
    }
}
