package arcomat.simulate.test;

import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.semantics.Execution;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Runs stream tests against one execution: a test passes if that sends just what is expected. */
public final class ExecutedTests {
    private ExecutedTests() {}

    /**
     * Runs a test against an execution of its component. Where the model leaves a choice, that has
     * made one, and a test that expects another fails.
     *
     * @param execution that has not stepped yet
     */
    public static StreamTestResult run(StreamTest test, Execution execution) {
        Trace trace = Simulation.run(execution, StreamTests.letters(test, execution.component()));
        List<Cell> cells = StreamTests.cells(test, trace, List.of());
        int inputs = test.inputs().size();
        Optional<String> failure = trace.failure().filter(f -> trace.steps().size() < inputs);
        OptionalInt difference =
                cells.stream().filter(Cell::differs).mapToInt(Cell::slice).findFirst();
        boolean passed = difference.isEmpty() && failure.isEmpty();
        return new StreamTestResult(
                test,
                passed ? Verdict.PASSED : Verdict.FAILED,
                cells,
                difference,
                OptionalInt.empty(),
                "",
                failure);
    }
}
