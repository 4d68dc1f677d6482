package arcomat.check.structure.feature;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.Needs.NAMES;
import static arcomat.check.law.Law.error;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class FeatureLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0151", new ConstraintsAllowSomething()),
                    error("ARC0152", new FeaturesChosen()).needing(NAMES),
                    error("ARC0150", new FeaturesWellFormed()).needing(ALL));

    private FeatureLaws() {}
}
