package arcomat.check.behaviour.action;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.expressions.Typed;

/** ARC0341: the condition of an {@code if} is Boolean. */
public final class ConditionIsBoolean implements Check.OnActions {

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        for (ActionSymbol.Choose choice : actions.choices()) {
            Typed condition = choice.condition();
            if (!condition.type().isErroneous() && !condition.type().isBoolean()) {
                findings.report(
                        condition.expression().node(),
                        "a condition is true or false, but this is of type %s; compare it with"
                                + " something",
                        condition.type().text());
            }
        }
    }
}
