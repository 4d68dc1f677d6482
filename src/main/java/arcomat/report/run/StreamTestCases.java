package arcomat.report.run;

import arcomat.report.finding.Case;
import arcomat.report.finding.Case.Outcome;
import arcomat.report.finding.FindingsText;
import arcomat.report.text.Style;
import arcomat.simulate.StreamTestResult;
import arcomat.simulate.StreamTestResult.Verdict;

import java.util.List;
import java.util.Optional;

/** Results of stream tests as cases, one each. */
public final class StreamTestCases {
    private StreamTestCases() {}

    public static List<Case> of(List<StreamTestResult> results) {
        return results.stream().map(StreamTestCases::of).toList();
    }

    private static Case of(StreamTestResult result) {
        boolean failed = result.verdict() == Verdict.FAILED;
        return new Case(
                result.test().suite(),
                result.test().name(),
                Optional.of(result.test().span()),
                failed ? Outcome.FAILED : Outcome.PASSED,
                failed ? StreamTestText.reason(result) : "",
                switch (result.verdict()) {
                    case PASSED -> "";
                    case VACUOUS -> "vacuous: " + StreamTestText.vacuous(result) + "\n";
                    case FAILED -> details(result);
                });
    }

    private static String details(StreamTestResult result) {
        String place = FindingsText.place(result.test().span());
        String streams = StreamTestText.sideBySide(result, Style.PLAIN);
        return place + ": " + StreamTestText.reason(result) + "\n" + streams;
    }
}
