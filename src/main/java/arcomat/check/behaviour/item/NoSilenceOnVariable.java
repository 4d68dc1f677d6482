package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;

/** ARC0313: neither silence nor "any message" makes sense for a variable. (Wor16 AT3) */
public final class NoSilenceOnVariable implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        Items.ofVariable(
                item,
                (variable, part) -> {
                    if (part instanceof ItemValue.Mark) {
                        findings.report(
                                part.node(),
                                "'%s' is about messages, but variable '%s' always has a value;"
                                        + " write a value or drop the item",
                                part.node().span().text(),
                                variable.name());
                    }
                });
    }
}
