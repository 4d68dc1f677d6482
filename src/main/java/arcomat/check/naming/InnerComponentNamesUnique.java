package arcomat.check.naming;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;

/** ARC0215: the components declared inside one component differ in name. */
public final class InnerComponentNamesUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Duplicates.report(
                component.innerComponents().stream().map(inner -> inner.node().name()).toList(),
                findings,
                "component '%s' declares an inner component '%s' already; rename one, or use it"
                        + " for both parts",
                component.name(),
                "the first one");
    }
}
