package arcomat.analysis.automaton.exploration;

import java.util.List;
import java.util.Set;

/**
 * What is known of traps, where configurations cannot be looked at one by one.
 *
 * @param entered traps that a run enters
 * @param obstacle why it is open whether there is another one; else empty
 */
public record Traps(List<Entry> entered, String obstacle) {
    /** There is none. */
    public static final Traps NONE = new Traps(List.of(), "");

    public Traps {
        entered = List.copyOf(entered);
    }

    /**
     * A run into a trap.
     *
     * @param visit a shortest one to where the trap is known to begin
     * @param states those that it may come to from there
     * @param isWhole whether it comes to all of these
     */
    public record Entry(Visit visit, Set<Integer> states, boolean isWhole) {}
}
