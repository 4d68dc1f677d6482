package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Difference;
import arcomat.analysis.refinement.Promise;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;

import java.util.List;
import java.util.Optional;

/** Compares two components in both directions. */
public final class DiffStep {
    private DiffStep() {}

    public static DiffResult run(
            RefinesRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths,
                        Asked.components(List.of(request.left(), request.right())),
                        names,
                        progress);
        if (checked.hasErrors()) {
            return new DiffResult(
                    checked.result(), request.left(), request.right(), Optional.empty());
        }
        Model model = checked.lower(progress);
        Promise left =
                RefinesStep.promise(request.left(), request.leftCompletion(), checked, model);
        Promise right =
                RefinesStep.promise(request.right(), request.rightCompletion(), checked, model);
        progress.step("comparing");
        Difference difference = Difference.of(left, right, request.limits().budget());
        return new DiffResult(
                checked.result(), left.title(), right.title(), Optional.of(difference));
    }
}
