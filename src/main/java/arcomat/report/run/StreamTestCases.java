package arcomat.report.run;

import arcomat.report.finding.FindingsText;
import arcomat.report.finding.JunitXml.Case;
import arcomat.report.finding.JunitXml.Case.Outcome;
import arcomat.report.text.Style;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.List;
import java.util.Optional;

/** Results of stream tests as cases, one each. */
public final class StreamTestCases {
    private StreamTestCases() {}

    public static List<Case> of(List<StreamTestResult> results) {
        return results.stream().map(StreamTestCases::of).toList();
    }

    private static Case of(StreamTestResult result) {
        return new Case(
                result.test().qualifiedSuite(),
                result.test().name(),
                Optional.of(result.test().span()),
                outcome(result.verdict()),
                switch (result.verdict()) {
                    case PASSED, VACUOUS -> "";
                    case FAILED -> StreamTestText.reason(result);
                    case UNKNOWN -> "unknown: " + StreamTestText.reason(result);
                },
                switch (result.verdict()) {
                    case PASSED -> "";
                    case VACUOUS -> "vacuous: " + StreamTestText.vacuous(result) + "\n";
                    case FAILED -> details(result);
                    case UNKNOWN ->
                            place(result) + ": unknown: " + StreamTestText.reason(result) + "\n";
                });
    }

    private static Outcome outcome(Verdict verdict) {
        return switch (verdict) {
            case PASSED, VACUOUS -> Outcome.PASSED;
            case FAILED -> Outcome.FAILED;
            case UNKNOWN -> Outcome.UNDECIDED;
        };
    }

    private static String details(StreamTestResult result) {
        String streams = StreamTestText.sideBySide(result, Style.PLAIN);
        return place(result) + ": " + StreamTestText.reason(result) + "\n" + streams;
    }

    private static String place(StreamTestResult result) {
        return FindingsText.place(result.test().span());
    }
}
