package arcomat.check.structure;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InvariantSymbol;

/** ARC0132: an invariant is an expression about what can be seen in a slice: it is proved. */
public final class InvariantUnevaluated implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.warning("ARC0132").needing(Law.Needs.ALL);
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (InvariantSymbol invariant : component.ownInvariants()) {
            invariant
                    .obstacle()
                    .ifPresent(
                            reason ->
                                    findings.report(
                                            invariant.node().name(),
                                            "invariant '"
                                                    + invariant.name()
                                                    + "' is not looked at by any command: "
                                                    + reason));
        }
    }
}
