package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;

import java.util.List;

/** ARC0302: an automaton has at least one initial state (Wor16 AC4). */
public final class InitialRequired implements Check.OnAutomaton {

    /** An automaton without states has a finding already. */
    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        List<StateSymbol> states = automaton.states();
        if (!states.isEmpty() && automaton.initials().isEmpty()) {
            findings.report(
                    Automata.head(automaton),
                    "%s has no initial state; say where it starts, for example with 'initial %s;'",
                    Automata.subject(automaton),
                    states.get(0).name());
        }
    }
}
