package arcomat.analysis.automaton;

import java.util.List;

/** A question about one automaton. It is shown all that can happen, and says then what it found. */
interface Analysis {

    /** Takes note of what may happen in a configuration; shorter ways come first. */
    void see(Situation situation);

    /** What was found, in text order; that something never happens only if all was seen. */
    List<Finding> findings(Exploration explored);
}
