package arcomat.pipeline.analysis;

import arcomat.analysis.automaton.Examination;
import arcomat.analysis.automaton.Examination.Unexamined;
import arcomat.analysis.refinement.Verdict.Answer;
import arcomat.pipeline.check.CheckResult;

import java.util.List;

/**
 * What was found about automata.
 *
 * @param examinations empty where the models have errors
 * @param unexamined what would have to be asked differently
 * @param meant how many findings were suppressed in the models
 */
public record AnalyzeResult(
        CheckResult check, List<Examination> examinations, List<Unexamined> unexamined, int meant) {
    public AnalyzeResult {
        examinations = List.copyOf(examinations);
        unexamined = List.copyOf(unexamined);
    }

    /** Fails if something was found, is unknown if not everything was looked at, else holds. */
    public Answer answer() {
        Answer worst = unexamined.isEmpty() ? Answer.HOLDS : Answer.UNKNOWN;
        for (Examination each : examinations) {
            worst = worst.and(each.answer());
        }
        return worst;
    }
}
