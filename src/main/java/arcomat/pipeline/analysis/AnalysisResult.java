package arcomat.pipeline.analysis;

import arcomat.analysis.refinement.Answered;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * Answers about models.
 *
 * @param answers empty where the models have errors
 */
public record AnalysisResult(CheckResult check, List<Answered> answers) {
    public AnalysisResult {
        answers = List.copyOf(answers);
    }

    /** Fails if one does, is unknown if one is, else holds. */
    public Answer answer() {
        Answer worst = Answer.HOLDS;
        for (Answered each : answers) {
            worst = worst.and(each.verdict().answer());
        }
        return worst;
    }
}
