package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Obligations;
import arcomat.analysis.refinement.Obligations.Obligation;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;

import java.util.ArrayList;
import java.util.List;

/** Shows everything that has to be shown of the models that were named. */
public final class VerifyStep {
    private VerifyStep() {}

    public static AnalysisResult run(
            List<String> paths, AnalysisLimits limits, PathNames names, Progress progress) {
        CheckedModels checked =
                CheckedModels.checkToExamine(paths, Asked.WHAT_IS_WHOLE, names, progress);
        if (checked.hasErrors()) {
            return new AnalysisResult(checked.result(), List.of());
        }
        Model model = checked.lower(progress);
        List<Component> components =
                model.components().stream()
                        .filter(c -> checked.loaded().isNamedByUser(c.span().file().path()))
                        .toList();
        Obligations.All all = Obligations.of(model, components);
        Budget budget = limits.budget();
        List<Answered> answers = new ArrayList<>();
        for (Obligation obligation : all.obligations()) {
            String left = obligation.left().title();
            String right = obligation.right().title();
            progress.step("comparing " + left + " with " + right);
            Verdict verdict = Refinement.check(obligation.left(), obligation.right(), budget);
            List<Promise> sides = List.of(obligation.left(), obligation.right());
            answers.add(new Answered(left, right, obligation.place(), verdict, sides));
        }
        all.open()
                .forEach(name -> answers.add(takesArguments(model.component(name).orElseThrow())));
        answers.addAll(new InvariantAnswers(model, checked, components, budget, progress).all());
        return new AnalysisResult(checked.result(), answers);
    }

    private static Answered takesArguments(Component component) {
        String name = component.qualifiedName();
        String reason =
                name + " takes arguments; ask with some: arcomat refines '" + name + "(..)' B PATH";
        return new Answered(name, "", component.span(), Verdict.unknown(reason));
    }
}
