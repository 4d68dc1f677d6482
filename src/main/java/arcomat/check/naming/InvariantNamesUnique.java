package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

/** ARC0216: the invariants of a component differ in name. */
public final class InvariantNamesUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Duplicates.report(
                component.node().elements(Element.Invariant.class).stream()
                        .map(Element.Invariant::name)
                        .toList(),
                findings,
                "component '%s' has an invariant '%s' already; rename one of them",
                component.name(),
                "the first one");
    }
}
