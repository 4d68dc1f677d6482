package arcomat.analysis.mona;

import arcomat.analysis.mona.Bits.Condition;
import arcomat.analysis.mona.Bits.Cube;

import java.util.List;

/**
 * Everything that the text of a formula has in it: flat, for a template.
 *
 * @param left name of the left side, as models write it
 * @param valid what is true of the codes at every position {@code t}
 * @param fails whether a run may end with an error; those positions have a set of their own
 * @param rights one per automaton of the right side
 */
public record MonaFormula(
        String left,
        String right,
        List<TrackText> tracks,
        List<Condition> valid,
        boolean fails,
        SystemText machine,
        List<SystemText> rights) {
    /** A port: the meaning of its codes and the names of its bits, the lowest first. */
    public record TrackText(String legend, List<String> bits) {}

    /**
     * A side, or an automaton of it.
     *
     * @param name of the predicate
     * @param bits names of those of its state, the lowest first
     * @param picks names of those that say which of several steps is taken, if there are several
     */
    public record SystemText(
            String name,
            String title,
            List<String> bits,
            List<String> picks,
            List<StepText> openings,
            List<StateText> states) {}

    /** A state, and all that may happen in it; nothing where the run has ended. */
    public record StateText(String title, Cube code, List<StepText> steps) {}

    /**
     * What is read, sent and reached.
     *
     * @param origin the transition as it is written, or the completion; one line
     * @param conditions all of them hold; none where anything may happen
     */
    public record StepText(String origin, List<Condition> conditions) {}
}
