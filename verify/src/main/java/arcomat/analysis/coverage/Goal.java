package arcomat.analysis.coverage;

import arcomat.model.Automaton;

import java.util.List;
import java.util.stream.IntStream;

/** A transition of an automaton that a test is wanted for. */
public record Goal(Automaton automaton, int index) {
    /** One for each transition, in text order. */
    static List<Goal> of(Automaton automaton) {
        return IntStream.range(0, automaton.transitions().size())
                .mapToObj(index -> new Goal(automaton, index))
                .toList();
    }

    public Automaton.Transition transition() {
        return automaton.transitions().get(index);
    }

    /** The name of the state that it leads out of. */
    public String source() {
        return automaton.states().get(transition().source());
    }

    /** The name of the state that it leads to. */
    public String target() {
        return automaton.states().get(transition().target());
    }

    /** Automata are large, and each is there once. */
    @Override
    public boolean equals(Object other) {
        return other instanceof Goal that && automaton == that.automaton && index == that.index;
    }

    @Override
    public int hashCode() {
        return 31 * System.identityHashCode(automaton) + index;
    }
}
