package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.tree.Block;

/** ARC0333: an automaton that code is generated from knows what it sends. */
public final class AnyMessageOnOutput implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() != ItemSymbol.Side.INPUT
                && Items.variable(item).isEmpty()
                && !Items.isRequirement(context.automaton().orElseThrow())) {
            check(item.value(), findings);
        }
    }

    private static void check(ItemValue value, Findings findings) {
        if (value.node() instanceof Block.AnyMessage) {
            findings.report(
                    value.node(),
                    "'?' leaves open what is sent, so no code can be generated; write the message");
        }
    }
}
