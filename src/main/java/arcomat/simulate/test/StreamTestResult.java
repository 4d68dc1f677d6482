package arcomat.simulate.test;

import arcomat.model.StreamTest;
import arcomat.model.Value;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * What a stream test found, port by port and slice by slice, for a report with the streams side by
 * side.
 *
 * @param cells ordered by slice, then by port as the test lists them; event-driven: position in the
 *     stream of all messages of the port in place of the slice
 * @param firstDifference the slice from which on nothing that the model allows is what the test
 *     expects
 * @param vacuousFrom the slice, or event, from which on only chaos allowed what the test expects
 * @param chaotic what promises nothing any more from there on, in words; empty where nothing is
 *     vacuous
 * @param failure why the run ended early: the model itself went wrong; why nobody knows, where that
 *     is the verdict
 */
public record StreamTestResult(
        StreamTest test,
        Verdict verdict,
        List<Cell> cells,
        OptionalInt firstDifference,
        OptionalInt vacuousFrom,
        String chaotic,
        Optional<String> failure) {
    public StreamTestResult {
        cells = List.copyOf(cells);
    }

    /** How a stream test ended. */
    public enum Verdict {
        PASSED,
        /** The output is allowed only because the model promises nothing any more. */
        VACUOUS,
        FAILED,
        /** It leaves too much open to be decided. */
        UNKNOWN
    }

    /**
     * One port in one slice.
     *
     * @param expected what the test asks for
     * @param actual what a run with first choices, or compiled code, sends
     * @param allowed what the model allows after outputs that were as expected, each as text; told
     *     only in the slice of the first difference
     * @param differs whether the expectation of a failed test fails here: not allowed by the model,
     *     or not sent by compiled code
     */
    public record Cell(
            int slice,
            String port,
            List<Value> expected,
            List<Value> actual,
            List<String> allowed,
            boolean differs) {
        public Cell {
            expected = List.copyOf(expected);
            actual = List.copyOf(actual);
            allowed = List.copyOf(allowed);
        }

        Cell with(boolean difference) {
            return new Cell(slice, port, expected, actual, allowed, difference);
        }
    }
}
