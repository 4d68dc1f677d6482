package arcomat.pipeline.watch;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.search.Budget;
import arcomat.pipeline.Session;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;

import java.util.List;

/**
 * Shows what some models say that they keep.
 *
 * @param paths of files that refer to each other and to no other ones
 */
record ShowPromises(List<String> paths, Budget budget) implements ModelQuestion<List<Answered>> {
    @Override
    public Asked asked() {
        return Asked.WHAT_IS_WHOLE;
    }

    @Override
    public List<Answered> answer(LoweredModels models, Session session) {
        return VerifyPromises.answers(models, budget, session.progress());
    }
}
