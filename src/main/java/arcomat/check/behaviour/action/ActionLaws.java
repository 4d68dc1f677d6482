package arcomat.check.behaviour.action;

import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class ActionLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0345", new ActionsBounded()),
                    error("ARC0341", new ConditionIsBoolean()),
                    error("ARC0342", new LocalNameFree()),
                    error("ARC0343", new LocalWithoutRange()),
                    error("ARC0344", new NoChoiceAtTheStart()),
                    warning("ARC0355", new SilenceStaysInBranch()));

    private ActionLaws() {}
}
