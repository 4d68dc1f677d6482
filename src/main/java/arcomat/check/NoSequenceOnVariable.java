package arcomat.check;

import arcomat.symbols.ItemSymbol;
import arcomat.symbols.ItemValue;
import arcomat.symbols.VariableSymbol;

/** ARC0312: no list of messages is stored in a variable or compared with one. (RRW14a T5) */
final class NoSequenceOnVariable implements Check.OnItem {

    @Override
    public Law law() {
        return Law.error("ARC0312");
    }

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
                        "variable '"
                                + variable.name()
                                + "' holds one value, not a list; write "
                                + (item.side() == ItemSymbol.Side.INPUT
                                        ? "one value, or several in 'alt {..}'"
                                        : "one value"));
            }
        }
    }
}
