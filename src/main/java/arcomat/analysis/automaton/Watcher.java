package arcomat.analysis.automaton;

/** Is shown all that can happen. */
interface Watcher {

    /** Takes note of what may happen in a configuration; shorter ways come first. */
    void see(Situation situation);
}
