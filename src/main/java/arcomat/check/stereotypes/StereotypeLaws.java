package arcomat.check.stereotypes;

import static arcomat.check.law.Law.error;
import static arcomat.check.law.Law.warning;

import arcomat.check.law.Law;

import java.util.List;
import java.util.function.Supplier;

/** One line for each law of this folder, in alphabetical order. */
public final class StereotypeLaws {
    private StereotypeLaws() {}

    /**
     * @param laws all laws that there are, these included
     */
    public static List<Law> all(Supplier<List<Law>> laws) {
        return List.of(
                error("ARC0505", new LayerOrder()),
                error("ARC0504", new LogicWithoutPlatform()),
                error("ARC0503", new StereotypeInPlace()),
                warning("ARC0501", new StereotypeKnown()),
                error("ARC0502", new StereotypeValue()),
                error("ARC0506", new SuppressWellFormed(laws)),
                warning(SuppressionUsed.CODE, new SuppressionUsed()));
    }
}
