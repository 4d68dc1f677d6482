package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Difference;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.semantics.Promise;

import java.util.List;

/** Compares two components in both directions. */
public record CompareComponents(ComparedSides sides, List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<CompareComponents.Found> {
    /**
     * How two components compare.
     *
     * @param left title of the left one
     * @param right title of the right one
     */
    public record Found(String left, String right, Difference difference) {}

    @Override
    public Asked asked() {
        return sides.asked();
    }

    @Override
    public Found answer(LoweredModels models, Session session) throws WrongUse {
        Promise left = sides.left(models);
        Promise right = sides.right(models);
        session.progress().step("comparing");
        return new Found(left.title(), right.title(), Difference.of(left, right, limits.budget()));
    }
}
