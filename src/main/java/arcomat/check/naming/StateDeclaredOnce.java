package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;

/** ARC0203: no state of an automaton is declared twice (Wor16 AU1). */
public final class StateDeclaredOnce implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Duplicates.report(
                automaton.states().stream().map(state -> state.node().name()).toList(),
                (name, first) ->
                        findings.report(
                                        name,
                                        "state '%s' is declared twice; remove or rename one",
                                        name)
                                .related(first, "first declared here"));
    }
}
