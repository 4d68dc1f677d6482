package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.StateSymbol;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0203: no state of an automaton is declared twice (Wor16 AU1). */
public final class StateDeclaredOnce implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0203");
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (StateSymbol state : automaton.states()) {
            Name name = state.node().name();
            Name first = seen.putIfAbsent(name.text(), name);
            if (first != null) {
                findings.report(
                                name,
                                "state '" + name + "' is declared twice; remove or rename one")
                        .related(first, "first declared here");
            }
        }
    }
}
