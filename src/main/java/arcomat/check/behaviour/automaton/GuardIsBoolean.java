package arcomat.check.behaviour.automaton;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.TransitionSymbol;

/** ARC0315: a guard is Boolean. (Wor16 AT1) */
public final class GuardIsBoolean implements Check.OnTransition {

    @Override
    public void check(TransitionSymbol transition, Context context, Findings findings) {
        transition
                .guard()
                .filter(guard -> !guard.type().isErroneous() && !guard.type().isBoolean())
                .ifPresent(
                        guard ->
                                findings.report(
                                        guard.expression().node(),
                                        "a guard is true or false, but this is of type %s; compare"
                                                + " it with something",
                                        guard.type().text()));
    }
}
