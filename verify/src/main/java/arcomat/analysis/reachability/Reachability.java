package arcomat.analysis.reachability;

import arcomat.model.Value;

import java.util.List;

/** What is known about a {@link RunProperty}. */
public sealed interface Reachability {

    /** A shortest run shows it. */
    record Reachable(Run run) implements Reachability {}

    /** No run shows it. */
    record Unreachable() implements Reachability {}

    /**
     * Neither.
     *
     * @param reason what stood in the way
     */
    record Unknown(String reason) implements Reachability {}

    /**
     * A run, and the letter after it on which something is to be seen.
     *
     * @param letters one per step; messages by position of the input port, null for silence
     * @param places where the automaton is before each of the letters, and at the end
     * @param last the letter at the end
     */
    record Run(List<Value[]> letters, List<Place> places, Value[] last) {}

    /** A state with the values of the variables. */
    record Place(int state, List<Value> variables) {}
}
