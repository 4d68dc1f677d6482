package arcomat.live;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Finding;
import arcomat.analysis.contradiction.Consistency;
import arcomat.analysis.contradiction.Contradictions;
import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Moment;
import arcomat.live.json.JsonText;
import arcomat.pipeline.Progress;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalyzeAutomata;
import arcomat.pipeline.analysis.VerifyPromises;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.report.text.Style;
import arcomat.report.verdict.ConsistencyText;
import arcomat.report.verdict.ExaminationText;
import arcomat.report.verdict.VerdictText;
import arcomat.rt.ModelError;
import arcomat.semantics.Promise;

import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** What the page asks about promises; the sentences are those of the command line. */
record Proofs(LoweredModels models, Budget budget) {

    String refines(String left, String right) throws WrongUse {
        Promise one = PromiseReference.parse(left).in(models);
        Promise other = PromiseReference.parse(right).in(models);
        Verdict verdict = Refinement.check(one, other, budget);
        Answered answered =
                new Answered(
                        one.title(),
                        other.title(),
                        one.component().span(),
                        verdict,
                        List.of(one, other));
        return answers(List.of(answered));
    }

    String verify() {
        return answers(VerifyPromises.answers(models, budget, Progress.NONE));
    }

    String analyze() {
        AnalyzeAutomata.Found found = AnalyzeAutomata.all(models, List.of(), budget, Progress.NONE);
        return JsonText.object(
                json -> {
                    json.objects("answers", found.examinations(), Proofs::examination);
                    json.strings(
                            "open",
                            found.unexamined().stream()
                                    .map(each -> ExaminationText.render(each, Style.PLAIN))
                                    .toList());
                });
    }

    String contradictions(String component) throws WrongUse {
        Promise promise = PromiseReference.parse(component).automataIn(models);
        Consistency found;
        try {
            found = Contradictions.check(promise, false, budget);
        } catch (ModelError error) {
            throw new WrongUse(
                    "the model goes wrong before it reads anything: " + error.getMessage());
        }
        String text =
                ConsistencyText.render(
                        promise.title(), found, Optional.empty(), Optional.empty(), Style.PLAIN);
        return JsonText.object(
                json ->
                        json.objects(
                                "answers",
                                List.of(found),
                                (each, one) -> {
                                    answer(each, one.answer());
                                    each.field("text", text);
                                }));
    }

    private static String answers(List<Answered> answers) {
        return JsonText.object(json -> json.objects("answers", answers, Proofs::answered));
    }

    private static void answered(JsonText json, Answered answered) {
        answer(json, answered.verdict().answer());
        json.field("left", answered.left());
        json.field("right", answered.right());
        json.field("text", VerdictText.render(answered, Style.PLAIN));
        json.objects("moments", answered.verdict().trace(), Proofs::moment);
    }

    private static void moment(JsonText json, Moment moment) {
        json.strings("inputs", VerdictText.inputs(moment.input()));
        json.strings("outputs", VerdictText.shown(moment));
        json.field("left", moment.left());
        json.strings("right", moment.right());
    }

    private static void examination(JsonText json, Examination examination) {
        answer(json, examination.answer());
        json.field("text", ExaminationText.render(examination, Style.PLAIN));
        json.objects(
                "places",
                examination.findings().stream().map(Finding::diagnostic).toList(),
                (each, finding) -> ModelAnswers.place(each, finding.span()));
    }

    private static void answer(JsonText json, Verdict.Answer answer) {
        json.field("answer", answer.name().toLowerCase(Locale.ROOT));
    }
}
