package arcomat.check;

import arcomat.symbols.ComponentSymbol;
import arcomat.tree.Element;

/**
 * ARC0132: what a model promises is written as an automaton. Invariants are kept and not looked at.
 */
final class InvariantUnevaluated implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.warning("ARC0132");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Element.Invariant invariant : component.node().elements(Element.Invariant.class)) {
            findings.report(
                    invariant.name(),
                    "invariant '"
                            + invariant.name()
                            + "' is not looked at by any command; write it as an automaton of a"
                            + " component that this one refines, and 'arcomat verify' proves it");
        }
    }
}
