package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.tree.Name;

/** ARC0305: the name of an item is a port or a variable. (Wor16 AR1) */
public final class ItemNameExists implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        boolean mayBeInherited =
                context.component().filter(ComponentSymbol::lacksAncestor).isPresent();
        if (item.hasName() && item.target().isUnknown() && !mayBeInherited) {
            Name name = item.node().name().orElseThrow();
            String kind = item.side() == ItemSymbol.Side.INPUT ? "input" : "output";
            findings.reportUnknown(
                    name.span(),
                    "there is no " + kind + " port or variable '" + name + "'",
                    name.text(),
                    Items.candidates(context.automaton().orElseThrow(), item.side()),
                    "declare it");
        }
    }
}
