package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0206: the automata of one component differ in name. */
public final class AutomataNamesUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0206");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (AutomatonSymbol automaton : component.ownAutomata()) {
            automaton.node().name().ifPresent(name -> check(name, seen, component, findings));
        }
    }

    private static void check(
            Name name, Map<String, Name> seen, ComponentSymbol component, Findings findings) {
        Name first = seen.putIfAbsent(name.text(), name);
        if (first != null) {
            findings.report(
                            name,
                            "component '"
                                    + component.name()
                                    + "' has two automata named '"
                                    + name
                                    + "'; rename one")
                    .related(first, "the other one is declared here");
        }
    }
}
