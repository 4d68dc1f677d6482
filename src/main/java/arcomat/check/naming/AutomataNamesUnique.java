package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;

/** ARC0206: the automata of one component differ in name. */
public final class AutomataNamesUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Duplicates.report(
                component.ownAutomata().stream().flatMap(a -> a.node().name().stream()).toList(),
                findings,
                "component '%s' has two automata named '%s'; rename one",
                component.name(),
                "the other one is declared here");
    }
}
