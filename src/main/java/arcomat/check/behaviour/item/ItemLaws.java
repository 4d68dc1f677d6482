package arcomat.check.behaviour.item;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.executableError;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ItemLaws {
    public static final List<Law> LAWS =
            List.of(
                    executableError("ARC0333", new AnyMessageOnOutput()),
                    warning("ARC0337", new ComparedWithItself()),
                    error("ARC0321", new InitialOutputDelayed()).needing(ALL),
                    error("ARC0317", new InitialValueFits()),
                    error("ARC0306", new InputSideReads()),
                    error("ARC0305", new ItemNameExists()).needing(NAMES),
                    error("ARC0316", new ItemTypeFits()).needing(NAMES),
                    error("ARC0311", new NoAlternativesOnOutput()),
                    error("ARC0350", new NoConditionAsMessage()).needing(NAMES),
                    error("ARC0312", new NoSequenceOnVariable()),
                    error("ARC0313", new NoSilenceOnVariable()),
                    error("ARC0318", new OmittedNameUnique()).needing(ALL),
                    error("ARC0307", new OutputSideWrites()),
                    error("ARC0314", new SingleMessagePerSlice()).needing(NAMES),
                    error("ARC0325", new SupportedItem()));

    private ItemLaws() {}
}
