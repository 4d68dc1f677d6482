package arcomat.pipeline.analysis;

import arcomat.analysis.evolution.Evolution;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.check.PromiseReference;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.List;

/**
 * Compares versions of a component with all earlier ones.
 *
 * @param versions components as written, the oldest first
 */
public record FollowEvolution(List<String> versions, List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<Evolution> {
    @Override
    public Asked asked() {
        return Asked.components(versions);
    }

    @Override
    public Evolution answer(LoweredModels models, Session session) throws WrongUse {
        List<Promise> promises = new ArrayList<>();
        for (String version : versions) {
            promises.add(PromiseReference.parse(version).in(models));
        }
        session.progress().step("comparing", versions.size(), "version");
        return Evolution.of(promises, limits.budget());
    }
}
