package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.tree.Block;

/** ARC0333: an automaton or a table that code is generated from knows what it sends. */
public final class AnyMessageOnOutput implements Check.OnItem, Check.OnTable {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() != ItemSymbol.Side.INPUT
                && Items.variable(item).isEmpty()
                && !Items.isRequirement(context.automaton().orElseThrow())) {
            check(item.value(), findings);
        }
    }

    @Override
    public void check(TableSymbol table, Context context, Findings findings) {
        for (TableSymbol.Row row : table.rows()) {
            row.outputs().forEach(cell -> check(cell, findings));
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
