package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.TypeSymbol;

/** ARC0315: a guard is Boolean. (Wor16 AT1) */
public final class GuardIsBoolean implements Check.OnTransition {

    @Override
    public void check(TransitionSymbol transition, Context context, Findings findings) {
        transition.guard().ifPresent(guard -> check(guard, findings));
    }

    private static void check(Typed guard, Findings findings) {
        TypeSymbol type = guard.type();
        if (!type.isErroneous() && !type.isBoolean()) {
            findings.report(
                    guard.expression().node(),
                    "a guard is true or false, but this is of type %s; compare it with something",
                    type.text());
        }
    }
}
