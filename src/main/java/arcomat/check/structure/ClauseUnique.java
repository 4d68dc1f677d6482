package arcomat.check.structure;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;

import java.util.List;

/** ARC0130: a clause that speaks of the whole component stands in it once. */
public final class ClauseUnique implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0130");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        check("timing", component.node().elements(Element.Timing.class), findings);
        check("autoconnect", component.node().elements(Element.Autoconnect.class), findings);
        check(
                "autoinstantiate",
                component.node().elements(Element.Autoinstantiate.class),
                findings);
    }

    private static void check(String name, List<? extends Element> clauses, Findings findings) {
        for (int i = 1; i < clauses.size(); i++) {
            findings.report(
                            clauses.get(i),
                            "this component has a clause '" + name + "' already; delete one")
                    .related(clauses.get(0), "the first one");
        }
    }
}
