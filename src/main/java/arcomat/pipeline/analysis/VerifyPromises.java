package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Obligations;
import arcomat.analysis.refinement.Obligations.Obligation;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;

import java.util.ArrayList;
import java.util.List;

/** Shows everything that has to be shown of the models that were named. */
public record VerifyPromises(List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<List<Answered>> {
    @Override
    public Asked asked() {
        return Asked.WHAT_IS_WHOLE;
    }

    @Override
    public List<Answered> answer(LoweredModels models, Session session) {
        return answers(models, limits.budget(), session.progress());
    }

    /** The same of models that somebody else has read, with limits of his own. */
    public static List<Answered> answers(LoweredModels models, Budget budget, Progress progress) {
        Obligations.All all = Obligations.of(models.model(), models.named());
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
                .forEach(
                        name ->
                                answers.add(
                                        takesArguments(
                                                models.model().component(name).orElseThrow())));
        answers.addAll(new InvariantAnswers(models, budget, progress).all());
        return answers;
    }

    private static Answered takesArguments(Component component) {
        String name = component.qualifiedName();
        String reason =
                name + " takes arguments; ask with some: arcomat refines '" + name + "(..)' B PATH";
        return new Answered(name, "", component.span(), Verdict.unknown(reason));
    }
}
