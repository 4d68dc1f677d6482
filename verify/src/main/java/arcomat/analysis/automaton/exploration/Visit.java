package arcomat.analysis.automaton.exploration;

import arcomat.analysis.search.letter.Letters;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.expression.Output;

import org.jspecify.annotations.Nullable;

import java.util.Comparator;
import java.util.Set;

/**
 * The shortest way to a configuration; among the shortest one of fewest messages, the first found.
 *
 * @param number visits of an exploration are numbered as they are proposed, from 0; others are -1
 * @param latched positions of the latched ports that have had a message; events only
 * @param before null at a beginning
 * @param letter what led here; null at a beginning
 * @param output what was sent on the way here
 * @param length letters from a beginning
 * @param messages on the whole way
 */
public record Visit(
        int number,
        Configuration configuration,
        Set<Integer> latched,
        @Nullable Visit before,
        Value @Nullable [] letter,
        Output output,
        int length,
        int messages) {

    private static final Comparator<Visit> SIMPLE_FIRST =
            Comparator.comparingInt(Visit::length).thenComparingInt(Visit::messages);

    /** Where to go on from: visits to the same place are the same. */
    public record Place(Configuration configuration, Set<Integer> latched) {}

    /** Where a run begins that is not one of an exploration. */
    public static Visit beginning(Configuration configuration, Output output) {
        return new Visit(-1, configuration, Set.of(), null, null, output, 0, 0);
    }

    /** One step further. */
    public Visit then(Reaction reaction, Set<Integer> nowLatched, Value[] read) {
        return new Visit(
                -1,
                reaction.next(),
                nowLatched,
                this,
                read,
                reaction.output(),
                length + 1,
                messages + Letters.messages(read));
    }

    public Place place() {
        return new Place(configuration, latched);
    }

    /** That with the shorter way, or with fewer messages on one as long; else the first. */
    public static Visit simpler(Visit first, Visit second) {
        return SIMPLE_FIRST.compare(second, first) < 0 ? second : first;
    }
}
