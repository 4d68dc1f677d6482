package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.tree.Block;

/** ARC0311: an output block sends one thing; alternatives are for the input side. */
public final class NoAlternativesOnOutput implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() != ItemSymbol.Side.INPUT
                && item.value().node() instanceof Block.Alternatives alternatives) {
            findings.report(
                    alternatives,
                    "'alt' says what is waited for; to leave open what is sent, write one %s for"
                            + " each of the %s alternatives",
                    item.side() == ItemSymbol.Side.OUTPUT ? "transition" : "initial clause",
                    alternatives.values().size());
        }
    }
}
