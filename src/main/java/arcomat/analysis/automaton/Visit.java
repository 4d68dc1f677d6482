package arcomat.analysis.automaton;

import arcomat.model.Value;
import arcomat.semantics.Configuration;
import arcomat.semantics.Output;

import java.util.Set;

/**
 * The shortest way to a configuration; among the shortest one of fewest messages, the first found.
 *
 * @param number visits are numbered as they are proposed, from 0
 * @param latched positions of the latched ports that have had a message; events only
 * @param before null at a beginning
 * @param letter what led here; null at a beginning
 * @param output what was sent on the way here
 * @param length letters from a beginning
 * @param messages on the whole way
 */
record Visit(
        int number,
        Configuration configuration,
        Set<Integer> latched,
        Visit before,
        Value[] letter,
        Output output,
        int length,
        int messages) {

    /** Where to go on from: visits to the same place are the same. */
    record Place(Configuration configuration, Set<Integer> latched) {}

    Place place() {
        return new Place(configuration, latched);
    }

    /** Whether the way is shorter, or as long with fewer messages. */
    boolean isSimplerThan(Visit other) {
        return length != other.length ? length < other.length : messages < other.messages;
    }
}
