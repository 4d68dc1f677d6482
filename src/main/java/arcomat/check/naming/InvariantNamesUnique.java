package arcomat.check.naming;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;
import arcomat.tree.Name;

import java.util.HashMap;
import java.util.Map;

/** ARC0216: the invariants of a component differ in name. */
public final class InvariantNamesUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0216");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, Name> seen = new HashMap<>();
        for (Element.Invariant invariant : component.node().elements(Element.Invariant.class)) {
            Name first = seen.putIfAbsent(invariant.name().text(), invariant.name());
            if (first != null) {
                findings.report(
                                invariant.name(),
                                "component '"
                                        + component.name()
                                        + "' has an invariant '"
                                        + invariant.name()
                                        + "' already; rename one of them")
                        .related(first, "the first one");
            }
        }
    }
}
