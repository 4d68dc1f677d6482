package arcomat.check.stereotypes;

import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;
import java.util.function.Predicate;

/** One line for each law of this folder, in alphabetical order. */
public final class StereotypeLaws {
    private StereotypeLaws() {}

    /**
     * @param known whether a law, or a guest, finds something with a code
     */
    public static List<Law> all(Predicate<String> known) {
        return List.of(
                error("ARC0505", new LayerOrder()),
                error("ARC0504", new LogicWithoutPlatform()),
                error("ARC0503", new StereotypeInPlace()),
                warning("ARC0501", new StereotypeKnown()),
                error("ARC0502", new StereotypeValue()),
                error("ARC0506", new SuppressWellFormed(known)),
                warning(SuppressionUsed.CODE, new SuppressionUsed()));
    }
}
