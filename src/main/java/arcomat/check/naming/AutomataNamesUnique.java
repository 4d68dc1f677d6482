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
                (name, first) ->
                        findings.report(
                                        name,
                                        "component '%s' has two automata named '%s'; rename one",
                                        component.name(),
                                        name)
                                .related(first, "the other one is declared here"));
    }
}
