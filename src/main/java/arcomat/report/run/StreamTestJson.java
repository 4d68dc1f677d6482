package arcomat.report.run;

import arcomat.report.text.Json;
import arcomat.report.text.Printable;
import arcomat.simulate.test.StreamTestResult;

import java.util.List;
import java.util.Optional;

/** Results of stream tests for programs, with the streams of every test slice by slice. */
public record StreamTestJson(List<Result> tests) {
    /**
     * A test.
     *
     * @param reason why nobody knows
     * @param failure why the run ended early
     */
    record Result(
            String file,
            int line,
            String suite,
            String name,
            String verdict,
            Optional<String> reason,
            Optional<String> failure,
            Optional<Integer> firstDifference,
            List<Cell> streams) {
        static Result of(StreamTestResult result) {
            boolean unknown = result.verdict() == StreamTestResult.Verdict.UNKNOWN;
            return new Result(
                    result.test().span().file().path(),
                    result.test().span().startPosition().line(),
                    result.test().qualifiedSuite(),
                    result.test().name(),
                    Printable.word(result.verdict()),
                    result.failure().filter(any -> unknown),
                    result.failure().filter(any -> !unknown),
                    result.firstDifference().stream().boxed().findFirst(),
                    result.cells().stream().map(Cell::of).toList());
        }
    }

    record Cell(
            int slice, String port, List<Object> expected, List<Object> actual, boolean differs) {
        static Cell of(StreamTestResult.Cell cell) {
            return new Cell(
                    cell.slice(),
                    cell.port(),
                    MessageJson.all(cell.expected()),
                    MessageJson.all(cell.actual()),
                    cell.differs());
        }
    }

    public static String render(List<StreamTestResult> results) {
        return Json.text(new StreamTestJson(results.stream().map(Result::of).toList()));
    }
}
