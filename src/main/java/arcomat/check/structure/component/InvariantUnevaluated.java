package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

/** ARC0132: an invariant is an expression about what can be seen in a slice: it is proved. */
public final class InvariantUnevaluated implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (InvariantSymbol invariant : component.ownInvariants()) {
            invariant
                    .obstacle()
                    .ifPresent(
                            reason ->
                                    findings.report(
                                            invariant.node().name(),
                                            "invariant '%s' is not looked at by any command: %s",
                                            invariant.title(),
                                            reason));
        }
    }
}
