package arcomat.check.refinement;

import arcomat.check.facts.UnresolvedComponents;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;

/** ARC0401: the component behind {@code refines} exists and is unambiguous. */
public final class RefinesExists implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Signature.Refinement refinement : component.signature().refines()) {
            UnresolvedComponents.check(
                    refinement.node(), refinement.resolution(), context, findings);
        }
    }
}
