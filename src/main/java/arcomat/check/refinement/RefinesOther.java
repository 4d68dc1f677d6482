package arcomat.check.refinement;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;

/** ARC0403: a component refines another one, not itself. */
public final class RefinesOther implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (Signature.Refinement refinement : component.signature().refines()) {
            if (refinement.resolution().found().filter(component.signature()::equals).isPresent()) {
                findings.report(
                        refinement.node(),
                        "component '%s' refines itself; name the other version with its package",
                        component.name());
            }
        }
    }
}
