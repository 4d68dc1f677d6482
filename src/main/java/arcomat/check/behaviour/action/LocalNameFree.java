package arcomat.check.behaviour.action;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.expressions.ValueSymbol;

/** ARC0342: a name that statements declare hides no other one. */
public final class LocalNameFree implements Check.OnActions {

    @Override
    public void check(ActionSymbol actions, Context context, Findings findings) {
        for (ActionSymbol.Declare declaration : actions.declarations()) {
            for (ActionSymbol.Local local : declaration.locals()) {
                local.hidden().ifPresent(hidden -> report(local, hidden, findings));
            }
        }
    }

    private static void report(ActionSymbol.Local local, ValueSymbol hidden, Findings findings) {
        findings.report(
                        local.variable().nameSpan(),
                        "local variable '%s' is named like %s; rename it",
                        local.variable().name(),
                        Items.words(hidden))
                .related(hidden.nameSpan(), "declared here");
    }
}
