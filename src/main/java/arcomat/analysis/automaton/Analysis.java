package arcomat.analysis.automaton;

import java.util.List;

/** A question about one automaton. It is shown all that can happen, and says then what it found. */
interface Analysis extends Watcher {

    /** What was found, in text order; that something never happens only if all was seen. */
    List<Finding> findings(Knowledge knowledge);
}
