package arcomat.check;

import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ItemSymbol;
import arcomat.tree.Name;

/** ARC0305: the name of an item is a port or a variable. (Wor16 AR1) */
final class ItemNameExists implements Check.OnItem {

    @Override
    public Law law() {
        return Law.error("ARC0305").needing(Law.Needs.NAMES);
    }

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
