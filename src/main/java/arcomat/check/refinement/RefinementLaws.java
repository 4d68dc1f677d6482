package arcomat.check.refinement;

import static arcomat.check.law.Law.Needs.ALL;
import static arcomat.check.law.Law.error;

import arcomat.check.law.Law;

import java.util.List;

/** One line for each law of this folder, in alphabetical order. */
public final class RefinementLaws {
    public static final List<Law> LAWS =
            List.of(
                    error("ARC0401", new RefinesExists()),
                    error("ARC0402", new RefinesInterface()).needing(ALL),
                    error("ARC0403", new RefinesOther()));

    private RefinementLaws() {}
}
