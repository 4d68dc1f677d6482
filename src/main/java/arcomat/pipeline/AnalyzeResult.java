package arcomat.pipeline;

import arcomat.analysis.Verdict.Answer;
import arcomat.analysis.automaton.Examination;

import java.util.List;

/**
 * What was found about automata.
 *
 * @param examinations empty where the models have errors
 * @param meant how many findings were suppressed in the models
 */
public record AnalyzeResult(CheckResult check, List<Examination> examinations, int meant) {
    public AnalyzeResult {
        examinations = List.copyOf(examinations);
    }

    /** Fails if something was found, is unknown if not everything was looked at, else holds. */
    public Answer answer() {
        Answer worst = Answer.HOLDS;
        for (Examination each : examinations) {
            worst = worst.and(each.answer());
        }
        return worst;
    }
}
