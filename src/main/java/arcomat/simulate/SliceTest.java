package arcomat.simulate;

import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.Network;
import arcomat.semantics.Sent;
import arcomat.simulate.StreamTestResult.Cell;
import arcomat.simulate.StreamTestResult.Verdict;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/** A stream test of a time-synchronous component against all that its model allows. */
final class SliceTest {
    private final StreamTest test;
    private Network network;
    private final List<Map<String, List<String>>> allowed = new ArrayList<>();
    private OptionalInt difference = OptionalInt.empty();
    private OptionalInt vacuousFrom = OptionalInt.empty();
    private Optional<String> failure = Optional.empty();

    SliceTest(StreamTest test) {
        this.test = test;
    }

    StreamTestResult run() {
        try {
            network = Network.of(test.component(), test.arguments());
            explore(new AllowedRuns(network));
        } catch (ModelError problem) {
            failure = Optional.of(problem.getMessage());
        }
        boolean failed = difference.isPresent() || failure.isPresent();
        Verdict passed = vacuousFrom.isPresent() ? Verdict.VACUOUS : Verdict.PASSED;
        return new StreamTestResult(
                test,
                failed ? Verdict.FAILED : passed,
                failed ? marked(cells()) : cells(),
                difference,
                vacuousFrom,
                failure);
    }

    private void explore(AllowedRuns runs) {
        Set<World> worlds = runs.starts();
        int inputs = test.inputs().size();
        for (int slice = 0; slice < inputs && !isSettled(); slice++) {
            requireTotals(test.inputs().get(slice), slice);
            List<Possibility> possible = runs.slice(worlds, test.inputs().get(slice));
            if (possible.isEmpty()) {
                String problem = runs.lastProblem().orElse("no run is possible");
                throw new ModelError("slice " + slice + ": " + problem);
            }
            worlds = AllowedRuns.worlds(agreeing(runs, possible, slice, true));
        }
        if (!isSettled() && StreamTests.length(test) > inputs) {
            agreeing(runs, worlds.stream().map(Possibility::new).toList(), inputs, false);
        }
    }

    private boolean isSettled() {
        return difference.isPresent();
    }

    private void requireTotals(Letter letter, int slice) {
        for (Network.External input : network.inputs()) {
            if (input.port().total() && letter.message(input.name()).isEmpty()) {
                throw new ModelError(
                        "slice "
                                + slice
                                + ": no message on "
                                + input.name()
                                + ", which is <<total>>");
            }
        }
    }

    /**
     * Keeps the possibilities with the expected outputs.
     *
     * @param evaluated whether the slice has been gone through, so that ports with delay 0 show
     *     something
     */
    private List<Possibility> agreeing(
            AllowedRuns runs, List<Possibility> possible, int slice, boolean evaluated) {
        List<Possibility> agreeing = new ArrayList<>(possible);
        Map<String, List<String>> seen = new LinkedHashMap<>();
        Map<String, Network.External> outputs = runs.outputs();
        test.expected()
                .forEach(
                        (port, stream) -> {
                            Network.External external = outputs.get(port);
                            if (slice < stream.size()
                                    && (evaluated || runs.isDelayed(external.signal()))) {
                                seen.put(port, texts(agreeing, external));
                                List<Value> expected = stream.get(slice);
                                agreeing.removeIf(p -> !runs.agrees(p, external, expected));
                            }
                        });
        allowed.add(seen);
        if (agreeing.isEmpty()) {
            difference = OptionalInt.of(slice);
        } else if (vacuousFrom.isEmpty() && agreeing.stream().allMatch(p -> p.vacuous)) {
            vacuousFrom = OptionalInt.of(slice);
        }
        return agreeing;
    }

    private static List<String> texts(List<Possibility> possible, Network.External external) {
        return possible.stream()
                .map(possibility -> AllowedRuns.seen(possibility, external))
                .distinct()
                .map(Sent::toString)
                .toList();
    }

    /** Streams side by side; no cell of a test that passes differs. */
    private List<Cell> cells() {
        Trace actual = StreamTests.firstRun(test);
        return StreamTests.cells(test, actual, allowed).stream()
                .map(cell -> with(cell, false))
                .toList();
    }

    /** In the slice of the difference, what is not allowed or not sent; later on, nothing. */
    private List<Cell> marked(List<Cell> cells) {
        int slice = difference.orElse(-1);
        List<Cell> marked = new ArrayList<>();
        for (Cell cell : cells) {
            marked.add(with(cell, cell.slice() == slice && !isAllowed(cell)));
        }
        boolean none = marked.stream().noneMatch(Cell::differs);
        return none
                ? cells.stream().map(cell -> with(cell, cell.slice() == slice)).toList()
                : marked;
    }

    private static boolean isAllowed(Cell cell) {
        Sent expected = new Sent.Messages(cell.expected());
        return cell.allowed().stream()
                .anyMatch(
                        text ->
                                text.equals(expected.toString())
                                        || text.equals(new Sent.Anything().toString())
                                        || text.equals(new Sent.AnyMessage().toString())
                                                && cell.expected().size() == 1);
    }

    private static Cell with(Cell cell, boolean differs) {
        return new Cell(
                cell.slice(), cell.port(), cell.expected(), cell.actual(), cell.allowed(), differs);
    }
}
