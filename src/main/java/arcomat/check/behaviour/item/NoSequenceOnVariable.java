package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.VariableSymbol;

/** ARC0312: no list of messages is stored in a variable or compared with one. (RRW14a T5) */
public final class NoSequenceOnVariable implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (Items.isOnItsSide(item)) {
            Items.variable(item).ifPresent(variable -> check(item, variable, findings));
        }
    }

    private static void check(ItemSymbol item, VariableSymbol variable, Findings findings) {
        for (ItemValue part : Items.parts(item.value())) {
            if (part instanceof ItemValue.Sequence) {
                findings.report(
                        part.node(),
                        "variable '%s' holds one value, not a list; write %s",
                        variable.name(),
                        item.side() == ItemSymbol.Side.INPUT
                                ? "one value, or several in 'alt {..}'"
                                : "one value");
            }
        }
    }
}
