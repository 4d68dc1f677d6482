package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.InitialSymbol;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0204: no state is declared initial twice (Wor16 AU2). */
public final class InitialDeclaredOnce implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0204");
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (InitialSymbol initial : automaton.initials()) {
            Name name = initial.name();
            Name first = seen.putIfAbsent(name.text(), name);
            if (first != null) {
                findings.report(
                                name,
                                "state '"
                                        + name
                                        + "' is declared initial twice; keep the declaration with"
                                        + " the output that is meant")
                        .related(first, "first declared initial here");
            }
        }
    }
}
