package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;

/** ARC0307: the output side sends on output ports and stores in variables. (Wor16 AR2) */
public final class OutputSideWrites implements Check.OnItem {

    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() != ItemSymbol.Side.INPUT && !Items.isOnItsSide(item)) {
            item.target().found().ifPresent(target -> report(item, target, findings));
        }
    }

    private static void report(ItemSymbol item, ValueSymbol target, Findings findings) {
        String advice =
                target instanceof PortSymbol
                        ? "it only receives; name an output port or a variable"
                        : "it keeps its value; declare a 'variable' in the automaton for what"
                                + " changes";
        findings.report(
                        Items.place(item),
                        "nothing can be written to %s: %s",
                        Items.words(target),
                        advice)
                .related(target.nameSpan(), "declared here");
    }
}
