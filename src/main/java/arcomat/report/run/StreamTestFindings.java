package arcomat.report.run;

import arcomat.report.finding.Reported;
import arcomat.report.finding.Reported.Standing;
import arcomat.simulate.test.StreamTestResult;
import arcomat.simulate.test.StreamTestResult.Verdict;
import arcomat.source.Diagnostic;
import arcomat.source.Span;

import java.util.List;

/**
 * Stream tests that fail as errors, and those that pass for no good reason or that are not decided
 * as warnings.
 */
public final class StreamTestFindings {
    /** A stream test fails. */
    public static final String FAILED = "ARC0711";

    /** A stream test passes only because the model promises nothing. */
    public static final String VACUOUS = "ARC0712";

    /** Nobody knows whether a stream test passes. */
    public static final String UNKNOWN = "ARC0713";

    private StreamTestFindings() {}

    public static List<Reported> of(List<StreamTestResult> results) {
        return results.stream()
                .filter(each -> each.verdict() != Verdict.PASSED)
                .map(each -> Reported.of(finding(each), Standing.NEW))
                .toList();
    }

    private static Diagnostic finding(StreamTestResult result) {
        Span place = result.test().span().firstLine();
        String name = "stream test '" + result.test().name() + "' ";
        return switch (result.verdict()) {
            case FAILED ->
                    Diagnostic.error(
                            FAILED, place, name + "fails: " + StreamTestText.reason(result));
            case UNKNOWN ->
                    Diagnostic.warning(
                            UNKNOWN, place, name + "is unknown: " + StreamTestText.reason(result));
            case PASSED, VACUOUS ->
                    Diagnostic.warning(
                            VACUOUS, place, name + "is vacuous: " + StreamTestText.vacuous(result));
        };
    }
}
