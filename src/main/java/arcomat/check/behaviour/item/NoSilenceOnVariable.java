package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.VariableSymbol;

/** ARC0313: neither silence nor "any message" makes sense for a variable. (Wor16 AT3) */
public final class NoSilenceOnVariable implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (Items.isOnItsSide(item)) {
            Items.variable(item).ifPresent(variable -> check(item, variable, findings));
        }
    }

    private static void check(ItemSymbol item, VariableSymbol variable, Findings findings) {
        for (ItemValue part : Items.parts(item.value())) {
            if (part instanceof ItemValue.Mark) {
                findings.report(
                        part.node(),
                        "'%s' is about messages, but variable '%s' always has a value; write a"
                            + " value or drop the item",
                        part.node().span().text(),
                        variable.name());
            }
        }
    }
}
