package arcomat.pipeline.analysis;

import arcomat.analysis.evolution.Evolution;
import arcomat.analysis.refinement.Promise;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Compares versions of a component with all earlier ones. */
public final class EvolutionStep {
    private EvolutionStep() {}

    public static EvolutionResult run(
            List<String> versions,
            List<String> paths,
            AnalysisLimits limits,
            PathNames names,
            Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(paths, Asked.components(versions), names, progress);
        if (checked.hasErrors()) {
            return new EvolutionResult(checked.result(), Optional.empty());
        }
        Model model = checked.lower(progress);
        List<Promise> promises = new ArrayList<>();
        for (String version : versions) {
            promises.add(PromiseReference.parse(version).in(checked, model));
        }
        progress.step("comparing", versions.size(), "version");
        return new EvolutionResult(
                checked.result(), Optional.of(Evolution.of(promises, limits.budget())));
    }
}
