package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;

/** ARC0312: no list of messages is stored in a variable or compared with one. (RRW14a T5) */
public final class NoSequenceOnVariable implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        String several = item.side() == ItemSymbol.Side.INPUT ? ", or several in 'alt {..}'" : "";
        Items.ofVariable(
                item,
                (variable, part) -> {
                    if (part instanceof ItemValue.Sequence) {
                        findings.report(
                                part.node(),
                                "variable '%s' holds one value, not a list; write one value%s",
                                variable.name(),
                                several);
                    }
                });
    }
}
