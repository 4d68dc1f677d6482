package arcomat.check.behaviour.action;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;

import java.util.Optional;

/** ARC0344: what is done before the first slice is always the same. */
public final class NoChoiceAtTheStart implements Check.OnActions {

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        if (context.side().equals(Optional.of(Side.INITIAL))) {
            for (ActionSymbol.Choose choice : actions.choices()) {
                findings.report(
                        choice.condition().expression().node(),
                        "nothing is decided before the first slice; write 'if condition then value"
                                + " else value' as a value, or decide in a transition");
            }
        }
    }
}
