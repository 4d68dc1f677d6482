package arcomat.check.structure.component;

import arcomat.check.facts.MeantParts;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Behaviour;
import arcomat.tree.Element;

/** ARC0125: before code is made, each component says what it does. */
public final class BehaviourPresent implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        boolean hasBehaviour =
                component.isDecomposed()
                        || component.isPlatform()
                        || !component.automata().isEmpty();
        boolean isExcused =
                component.lacksAncestor()
                        || MeantParts.mayBeIn(component)
                        || !component.node().elements(Element.JavaPart.class).isEmpty()
                        || !component.node().elements(Behaviour.Foreign.class).isEmpty();
        if (!hasBehaviour && !isExcused) {
            findings.report(
                    component.nameSpan(),
                    "component '%s' has no behaviour; add an automaton or a table, decompose it, or"
                            + " mark it <<platform>> if the target brings it",
                    component.name());
        }
    }
}
