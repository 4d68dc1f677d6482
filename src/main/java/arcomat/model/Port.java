package arcomat.model;

import arcomat.source.Span;

import java.util.Optional;

/**
 * A typed port.
 *
 * @param total carries a message in every slice
 * @param delay of an output, in slices: 0 or 1; 0 for inputs. Of a decomposed component that of the
 *     part which sends.
 * @param promised the delay that is written down: what automata on a decomposed component ask for
 * @param latched event-driven profile: a value that guards may read and that triggers nothing
 * @param first of a latched port, what it holds before its first message; empty where it holds
 *     nothing then
 */
public record Port(
        String name,
        Direction direction,
        Type type,
        boolean total,
        int delay,
        int promised,
        boolean latched,
        Optional<Value> first,
        Span span) {

    public enum Direction {
        IN,
        OUT
    }

    /** A port that sends as is written down, and holds nothing before its first message. */
    public Port(
            String name,
            Direction direction,
            Type type,
            boolean total,
            int delay,
            boolean latched,
            Span span) {
        this(name, direction, type, total, delay, delay, latched, Optional.empty(), span);
    }

    /** The port with a message in every slice. */
    public Port asTotal() {
        return new Port(name, direction, type, true, delay, promised, latched, first, span);
    }

    /** The same with another name. */
    public Port named(String other) {
        return new Port(other, direction, type, total, delay, promised, latched, first, span);
    }

    /** The port as automata on a decomposed component see it. */
    Port asPromised() {
        return new Port(name, direction, type, total, promised, promised, latched, first, span);
    }

    public boolean isInput() {
        return direction == Direction.IN;
    }

    @Override
    public String toString() {
        return name;
    }
}
