package arcomat.check.structure.component;

import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

/** ARC0130: a clause that speaks of the whole component stands in it once. */
public final class ClauseUnique implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        check("timing", Element.Timing.class, component, findings);
        check("autoconnect", Element.Autoconnect.class, component, findings);
        check("autoinstantiate", Element.Autoinstantiate.class, component, findings);
    }

    private static <T extends Element> void check(
            String name, Class<T> kind, ComponentSymbol component, Findings findings) {
        Duplicates.<Element>report(
                component.node().elements(kind),
                clause -> name,
                (clause, first) ->
                        findings.report(
                                        clause,
                                        "this component has a clause '%s' already; delete one",
                                        name)
                                .related(first, "the first one"));
    }
}
