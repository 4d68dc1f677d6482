package arcomat.check.refinement;

import arcomat.check.facts.ComponentNames;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;

/** ARC0401: the component behind {@code refines} exists and is unambiguous. */
public final class RefinesExists implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0401");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Signature.Refinement refinement : component.signature().refines()) {
            ComponentNames.check(refinement.node(), refinement.resolution(), context, findings);
        }
    }
}
