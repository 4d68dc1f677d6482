package arcomat.check;

import arcomat.symbols.AutomatonSymbol;

/** ARC0301: an automaton has at least one state (Wor16 AC3). */
final class StateRequired implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0301").needing(Law.Needs.ALL);
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (automaton.states().isEmpty()) {
            findings.report(
                    Automata.head(automaton),
                    Automata.subject(automaton)
                            + " has no state; declare its states with 'state a, b;'");
        }
    }
}
