package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.tree.Block;

import java.util.List;

/** ARC0325: a block holds messages and assignments, no calls and no increments. */
public final class SupportedItem implements Check.OnBlock {

    @Override
    public void check(Block block, List<ItemSymbol> items, Context context, Findings findings) {
        for (Block.Item item : block.items()) {
            if (item instanceof Block.Call) {
                findings.report(
                        item,
                        "there are no calls in a block; send a message to a component that does"
                                + " what the call did");
            } else if (item instanceof Block.Increment increment) {
                reportIncrement(increment, context, findings);
            }
        }
    }

    private static void reportIncrement(
            Block.Increment increment, Context context, Findings findings) {
        if (context.side().orElseThrow() == ItemSymbol.Side.INPUT) {
            findings.report(
                    increment,
                    "the input side only reads; write the new value of '%s' behind the '/'",
                    increment.name());
            return;
        }
        String name = increment.name().text();
        String assignment = name + " = " + name + (increment.up() ? " + 1" : " - 1");
        findings.report(increment, "write '%s' for '%s'", assignment, increment.span().text())
                .fix(Fix.replace("Write '" + assignment + "'", increment.span(), assignment));
    }
}
