package arcomat.analysis.automaton;

import java.util.List;

/** A question about one automaton. It is shown all that can happen, and says then what it found. */
interface Analysis extends Watcher {

    /** Takes note of nothing: for questions that what is known afterwards answers. */
    @Override
    default void see(Situation situation) {}

    /** What was found, in text order; that something never happens only if all was seen. */
    List<Finding> findings(Knowledge knowledge);
}
