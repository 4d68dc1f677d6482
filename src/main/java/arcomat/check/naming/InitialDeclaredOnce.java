package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;

/** ARC0204: no state is declared initial twice (Wor16 AU2). */
public final class InitialDeclaredOnce implements Check.OnAutomaton {

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Duplicates.report(
                automaton.initials().stream().map(InitialSymbol::name).toList(),
                (name, first) ->
                        findings.report(
                                        name,
                                        "state '%s' is declared initial twice; keep the declaration"
                                                + " with the output that is meant",
                                        name)
                                .related(first, "first declared initial here"));
    }
}
