package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Analyses;
import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.automaton.OutsideQuestion;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.analysis.search.Budget;
import arcomat.check.Checks;
import arcomat.check.Review;
import arcomat.model.Component;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.guest.GuestQuestion;
import arcomat.pipeline.check.Asked;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.ModelQuestion;
import arcomat.pipeline.check.PromiseReference;
import arcomat.semantics.Promise;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Examines automata, one by one.
 *
 * @param components as written, {@code p.Robot}, {@code p.Timer(2)} or {@code p.Robot#waits}; all
 *     that are named by path if empty
 */
public record AnalyzeAutomata(List<String> components, List<String> paths, AnalysisLimits limits)
        implements ModelQuestion<AnalyzeAutomata.Found> {
    /**
     * What was found about automata.
     *
     * @param unexamined what would have to be asked differently
     * @param meant how many findings were suppressed in the models
     */
    public record Found(List<Examination> examinations, List<Unexamined> unexamined, int meant) {
        /** Fails if something was found, is unknown if not everything was looked at, else holds. */
        public Answer answer() {
            return examinations.stream()
                    .map(Examination::answer)
                    .reduce(unexamined.isEmpty() ? Answer.HOLDS : Answer.UNKNOWN, Answer::and);
        }
    }

    @Override
    public Asked asked() {
        return Asked.components(components);
    }

    @Override
    public Found answer(LoweredModels models, Session session) throws WrongUse {
        List<Promise> promises = new ArrayList<>();
        for (String written : components) {
            promises.add(promise(written, models));
        }
        Budget budget = limits.budget();
        if (!components.isEmpty()) {
            return examine(
                    promises,
                    List.of(),
                    models,
                    GuestQuestion.all(session.guests()),
                    budget,
                    session.progress());
        }
        Found all = all(models, budget, session);
        if (all.examinations().isEmpty() && all.unexamined().isEmpty()) {
            throw new WrongUse("there is no automaton in " + String.join(", ", paths));
        }
        return all;
    }

    /** Of all models that were named. */
    public static Found all(LoweredModels models, Budget budget, Session session) {
        return all(models, GuestQuestion.all(session.guests()), budget, session.progress());
    }

    /**
     * The same for who has no session.
     *
     * @param outside questions of others
     */
    public static Found all(
            LoweredModels models, List<OutsideQuestion> outside, Budget budget, Progress progress) {
        InstancePromises all = new InstancePromises(models);
        return examine(all.all(), all.open(), models, outside, budget, progress);
    }

    private static Promise promise(String written, LoweredModels models) throws WrongUse {
        Promise promise = PromiseReference.parse(written).automataIn(models);
        Component component = promise.component();
        if (promise.automata().isEmpty()) {
            throw new WrongUse("component '" + component.qualifiedName() + "' has no automaton");
        }
        return promise;
    }

    /** What is found about automata and not declared to be meant. */
    public static List<Examination> examine(
            List<Promise> promises, LoweredModels models, AnalysisLimits limits, Session session) {
        return examine(
                        promises,
                        List.of(),
                        models,
                        GuestQuestion.all(session.guests()),
                        limits.budget(),
                        session.progress())
                .examinations();
    }

    private static Found examine(
            List<Promise> promises,
            List<Unexamined> unexamined,
            LoweredModels models,
            List<OutsideQuestion> outside,
            Budget budget,
            Progress progress) {
        List<Examination> examinations = new ArrayList<>();
        for (Promise promise : promises) {
            progress.step("examining " + promise.title());
            examinations.addAll(Analyses.examine(promise, outside, budget));
        }
        List<Diagnostic> all =
                examinations.stream()
                        .flatMap(each -> each.findings().stream())
                        .map(Finding::diagnostic)
                        .toList();
        Review review = Checks.sort(models.checked().workspace(), all);
        Set<Diagnostic> shown = new HashSet<>(review.findings());
        return new Found(
                examinations.stream().map(each -> only(shown, each)).toList(),
                unexamined,
                review.suppressed().size());
    }

    /** Findings that a model declares to be meant are left out. */
    private static Examination only(Set<Diagnostic> shown, Examination examination) {
        return examination.with(
                examination.findings().stream()
                        .filter(finding -> shown.contains(finding.diagnostic()))
                        .toList());
    }
}
