package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.refinement.Promise;
import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.pipeline.step.PathNames;
import arcomat.pipeline.step.Progress;
import arcomat.pipeline.step.WrongUse;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Examines automata, one by one. */
public final class AnalyzeStep {
    private AnalyzeStep() {}

    public static AnalyzeResult run(
            AnalyzeRequest request, List<String> paths, PathNames names, Progress progress)
            throws WrongUse {
        CheckedModels checked =
                CheckedModels.checkToExamine(
                        paths, Asked.components(request.components()), names, progress);
        if (checked.hasErrors()) {
            return new AnalyzeResult(checked.result(), List.of(), List.of(), 0);
        }
        Model model = checked.lower(progress);
        List<Promise> promises = new ArrayList<>(named(request, checked, model));
        List<Unexamined> unexamined = new ArrayList<>();
        if (request.components().isEmpty()) {
            InstancePromises all = new InstancePromises(model, checked);
            promises.addAll(all.all());
            unexamined.addAll(all.withoutArguments());
        }
        if (promises.isEmpty() && unexamined.isEmpty()) {
            throw new WrongUse("there is no automaton in " + String.join(", ", paths));
        }
        List<Examination> examinations = examine(promises, request.limits(), progress);
        return withoutMeant(examinations, unexamined, checked);
    }

    /** What is found about automata and not declared to be meant. */
    public static List<Examination> examine(
            List<Promise> promises,
            CheckedModels checked,
            AnalysisLimits limits,
            Progress progress) {
        List<Examination> examinations = examine(promises, limits, progress);
        return withoutMeant(examinations, List.of(), checked).examinations();
    }

    private static List<Examination> examine(
            List<Promise> promises, AnalysisLimits limits, Progress progress) {
        Budget budget = limits.budget();
        List<Examination> examinations = new ArrayList<>();
        for (Promise promise : promises) {
            progress.step("examining " + promise.title());
            examinations.addAll(Analyses.examine(promise, budget));
        }
        return examinations;
    }

    private static List<Promise> named(AnalyzeRequest request, CheckedModels checked, Model model)
            throws WrongUse {
        List<Promise> promises = new ArrayList<>();
        for (String written : request.components()) {
            Promise promise = PromiseReference.parse(written).in(checked, model);
            Component component = promise.component();
            if (promise.automata().isEmpty()) {
                promise = Promise.required(component, promise.arguments());
            }
            if (promise.automata().isEmpty()) {
                throw new WrongUse(
                        "component '" + component.qualifiedName() + "' has no automaton");
            }
            promises.add(promise);
        }
        return promises;
    }

    /** Findings that a model declares to be meant are left out. */
    private static AnalyzeResult withoutMeant(
            List<Examination> examinations, List<Unexamined> unexamined, CheckedModels checked) {
        List<Diagnostic> all =
                examinations.stream()
                        .flatMap(each -> each.findings().stream())
                        .map(Finding::diagnostic)
                        .toList();
        Review review = Checks.sort(checked.workspace(), all);
        Set<Diagnostic> shown = new HashSet<>(review.findings());
        List<Examination> rest = new ArrayList<>();
        for (Examination each : examinations) {
            rest.add(
                    each.with(
                            each.findings().stream()
                                    .filter(finding -> shown.contains(finding.diagnostic()))
                                    .toList()));
        }
        return new AnalyzeResult(checked.result(), rest, unexamined, review.suppressed().size());
    }
}
