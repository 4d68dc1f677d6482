package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.tree.Name;

/** ARC0305: the name of an item is a port or a variable. (Wor16 AR1) */
public final class ItemNameExists implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.hasName() && item.target().isUnknown()) {
            report(item, context.automaton().orElseThrow(), findings);
        }
    }

    private static void report(ItemSymbol item, AutomatonSymbol automaton, Findings findings) {
        Name name = item.node().name().orElseThrow();
        String kind = item.side() == ItemSymbol.Side.INPUT ? "input" : "output";
        findings.reportUnknown(
                name.span(),
                "there is no " + kind + " port or variable '" + name + "'",
                name.text(),
                Items.candidates(automaton, item.side()),
                "declare it");
    }
}
