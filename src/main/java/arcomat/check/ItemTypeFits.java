package arcomat.check;

import arcomat.symbols.ItemSymbol;
import arcomat.symbols.Typed;
import arcomat.symbols.ValueSymbol;

/** ARC0316: each message of an item has the type of its port or variable. (Wor16 AT2) */
final class ItemTypeFits implements Check.OnItem {

    @Override
    public Law law() {
        return Law.error("ARC0316").needing(Law.Needs.NAMES);
    }

    /** What stands on the wrong side has a finding already. */
    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (Items.isOnItsSide(item)) {
            ValueSymbol target = item.target().found().orElseThrow();
            for (Typed typed : item.value().expressions()) {
                if (!typed.isAssignableTo(target.type())) {
                    findings.report(
                                    typed.expression().node(),
                                    Items.words(target)
                                            + " takes "
                                            + Wording.mismatch(target.type(), typed))
                            .related(target.nameSpan(), "declared here");
                }
            }
        }
    }
}
