package arcomat.check.behaviour.action;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;

/** ARC0343: a local variable has no range: nothing watches what it holds in between. */
public final class LocalWithoutRange implements Check.OnActions {

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        for (ActionSymbol.Declare declaration : actions.declarations()) {
            declaration
                    .node()
                    .type()
                    .range()
                    .ifPresent(
                            range ->
                                    findings.report(
                                            range,
                                            "a local variable has no range: only what is kept or"
                                                    + " sent in the end is looked at; leave the"
                                                    + " range out"));
        }
    }
}
