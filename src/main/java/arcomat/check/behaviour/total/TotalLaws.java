package arcomat.check.behaviour.total;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class TotalLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0340", new FirstValueFits()).needing(ALL),
                    error("ARC0328", new IgnoreExcludesTotalOutput()),
                    error("ARC0326", new TotalInputHasTotalSender()).needing(ALL),
                    warning("ARC0338", new TotalInputNeverSilent()),
                    error("ARC0327", new TotalOutputNamed()).needing(ALL),
                    error("ARC0339", new TotalPortTimed()).needing(ALL));

    private TotalLaws() {}
}
