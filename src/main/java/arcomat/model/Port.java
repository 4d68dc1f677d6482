package arcomat.model;

import arcomat.source.Span;

/**
 * A typed port.
 *
 * @param total carries a message in every slice
 * @param delay of an output, in slices: 0 or 1; 0 for inputs
 * @param latched event-driven profile: a value that guards may read and that triggers nothing
 */
public record Port(
        String name,
        Direction direction,
        Type type,
        boolean total,
        int delay,
        boolean latched,
        Span span) {

    public enum Direction {
        IN,
        OUT
    }

    public boolean isInput() {
        return direction == Direction.IN;
    }

    @Override
    public String toString() {
        return name;
    }
}
