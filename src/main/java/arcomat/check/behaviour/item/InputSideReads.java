package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;

/** ARC0306: the input side asks for messages on input ports and for variables. (Wor16 AR2) */
public final class InputSideReads implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() == ItemSymbol.Side.INPUT && !Items.isOnItsSide(item)) {
            item.target().found().ifPresent(target -> report(item, target, findings));
        }
    }

    private static void report(ItemSymbol item, ValueSymbol target, Findings findings) {
        String advice =
                target instanceof PortSymbol
                        ? "keep what was sent in a variable or in the state"
                        : "ask for its value in a guard, as in '[" + target.name() + " == ..]'";
        findings.report(
                        Items.place(item),
                        "the input side cannot ask for %s; %s",
                        Items.words(target),
                        advice)
                .related(target.nameSpan(), "declared here");
    }
}
