package arcomat.check.behaviour.item;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.ValueSymbol;

/** ARC0316: each message of an item has the type of its port or variable. (Wor16 AT2) */
public final class ItemTypeFits implements Check.OnItem {

    /** What stands on the wrong side has a finding already. */
    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (Items.isOnItsSide(item)) {
            ValueSymbol target = item.target().found().orElseThrow();
            for (Typed typed : item.value().expressions()) {
                if (!typed.isAssignableTo(target.type())) {
                    findings.report(
                                    typed.expression().node(),
                                    "%s takes %s",
                                    Items.words(target),
                                    Wording.mismatch(target.type(), typed))
                            .related(target.nameSpan(), "declared here");
                }
            }
        }
    }
}
