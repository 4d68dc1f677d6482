package arcomat.pipeline.simulate;

import arcomat.pipeline.check.CheckResult;
import arcomat.simulate.test.StreamTestResult;

import java.util.List;

/**
 * What came of running stream tests.
 *
 * @param check findings about the models; errors keep every test from running
 * @param tests in the order of files and tests
 */
public record TestResult(CheckResult check, List<StreamTestResult> tests) {
    public TestResult {
        tests = List.copyOf(tests);
    }

    public boolean hasFailures() {
        return has(StreamTestResult.Verdict.FAILED);
    }

    /** Whether some test could not be decided. */
    public boolean hasUnknown() {
        return has(StreamTestResult.Verdict.UNKNOWN);
    }

    private boolean has(StreamTestResult.Verdict verdict) {
        return tests.stream().anyMatch(test -> test.verdict() == verdict);
    }
}
