package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;

/** ARC0301: an automaton has at least one state (Wor16 AC3). */
public final class StateRequired implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (automaton.states().isEmpty()) {
            findings.report(
                    Automata.head(automaton),
                    "%s has no state; declare its states with 'state a, b;'",
                    Automata.subject(automaton));
        }
    }
}
