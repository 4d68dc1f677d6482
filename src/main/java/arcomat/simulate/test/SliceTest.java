package arcomat.simulate.test;

import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.rt.ModelError;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.value.GivenUp;
import arcomat.simulate.test.AllowedBehaviour.Standing;
import arcomat.simulate.test.Possibility.NetworkState;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;

/** A stream test of a time-synchronous component against all that its model allows. */
final class SliceTest {
    private final StreamTest test;

    @SuppressWarnings("NullAway.Init") // built in the run, which reports what goes wrong then
    private Network network;

    private List<Map<String, List<String>>> allowed = List.of();
    private OptionalInt difference = OptionalInt.empty();
    private OptionalInt vacuousFrom = OptionalInt.empty();
    private String chaotic = "";
    private Optional<String> failure = Optional.empty();
    private Optional<String> undecided = Optional.empty();

    SliceTest(StreamTest test) {
        this.test = test;
    }

    StreamTestResult run() {
        try {
            network = Network.of(test.component(), test.arguments());
            explore(new AllowedRuns(network, StreamTests.mentioned(test)));
        } catch (ModelError problem) {
            failure = Optional.of(String.valueOf(problem.getMessage()));
        } catch (GivenUp tooMuch) {
            undecided = Optional.of(String.valueOf(tooMuch.getMessage()));
        }
        Verdict verdict = verdict();
        return new StreamTestResult(
                test,
                verdict,
                verdict == Verdict.FAILED ? marked(cells()) : cells(),
                difference,
                verdict == Verdict.VACUOUS ? vacuousFrom : OptionalInt.empty(),
                verdict == Verdict.VACUOUS ? chaotic : "",
                verdict == Verdict.UNKNOWN ? undecided : failure);
    }

    private Verdict verdict() {
        if (difference.isPresent() || failure.isPresent()) {
            return Verdict.FAILED;
        }
        if (undecided.isPresent()) {
            return Verdict.UNKNOWN;
        }
        return vacuousFrom.isPresent() ? Verdict.VACUOUS : Verdict.PASSED;
    }

    private void explore(AllowedRuns runs) {
        Map<NetworkState, Standing> worlds = runs.starts();
        int inputs = test.inputs().size();
        if (worlds.isEmpty()) {
            throw new ModelError("slice 0: its automata contradict each other to begin with");
        }
        for (int slice = 0; slice < inputs; slice++) {
            Letter letter = test.inputs().get(slice);
            requireTotals(letter, slice);
            Expected expected = Expected.in(slice, test, runs.wires(), true);
            List<Possibility> possible = runs.slice(worlds, letter, expected);
            if (possible.isEmpty() && runs.tooMany().isEmpty()) {
                List<Possibility> all = runs.slice(worlds, letter, Expected.NOTHING);
                if (all.isEmpty()) {
                    String problem = runs.lastProblem().orElse("no run is possible");
                    throw new ModelError("slice " + slice + ": " + problem);
                }
                differ(runs, all, slice, true);
            }
            judge(runs, possible, slice);
            if (possible.isEmpty()) {
                return;
            }
            worlds = AllowedRuns.worlds(possible);
        }
        if (StreamTests.length(test) > inputs) {
            Expected expected = Expected.in(inputs, test, runs.wires(), false);
            List<Possibility> possible = runs.registers(worlds, expected);
            if (possible.isEmpty() && runs.tooMany().isEmpty()) {
                differ(runs, runs.registers(worlds, Expected.NOTHING), inputs, false);
            }
            judge(runs, possible, inputs);
        }
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

    /** What the runs up to the end of a slice stand for: the best of them counts. */
    private void judge(AllowedRuns runs, List<Possibility> possible, int slice) {
        Optional<Standing> best =
                possible.stream().map(each -> each.standing).min(Standing::compareTo);
        if (best.isEmpty()) {
            undecided = runs.tooMany();
        } else if (best.get() == Standing.LOOSE) {
            undecided = runs.tooMany().or(() -> Optional.of(runs.untried()));
        } else if (best.get() == Standing.VACUOUS && vacuousFrom.isEmpty()) {
            vacuousFrom = OptionalInt.of(slice);
            chaotic = runs.chaotic(possible);
        }
    }

    /**
     * Notes what is allowed, port by port, in the slice in which nothing is that is expected.
     *
     * @param all that is possible in the slice
     * @param evaluated whether the slice has been gone through
     */
    private void differ(AllowedRuns runs, List<Possibility> all, int slice, boolean evaluated) {
        List<Possibility> agreeing = new ArrayList<>(all);
        Map<String, List<String>> seen = new LinkedHashMap<>();
        test.expected()
                .forEach(
                        (port, stream) -> {
                            if (Expected.isJudged(port, slice, test, runs.wires(), evaluated)) {
                                int signal = runs.wires().output(port);
                                seen.put(port, texts(runs, agreeing, signal));
                                Expected expected = Expected.on(signal, stream.get(slice));
                                agreeing.removeIf(each -> !runs.shows(each, signal, expected));
                            }
                        });
        allowed = new ArrayList<>(Collections.nCopies(slice, Map.of()));
        allowed.add(seen);
        difference = OptionalInt.of(slice);
    }

    private static List<String> texts(AllowedRuns runs, List<Possibility> possible, int signal) {
        Stream<String> texts =
                possible.stream().map(each -> AllowedRuns.seen(each, signal).toString()).distinct();
        return Stream.concat(texts, runs.tooMany().map(most -> "...").stream()).toList();
    }

    /** Streams side by side; no cell of a test that passes differs. */
    private List<Cell> cells() {
        Trace actual = StreamTests.firstRun(test);
        return StreamTests.cells(test, actual, allowed).stream()
                .map(cell -> cell.with(false))
                .toList();
    }

    /** In the slice of the difference, what is not allowed or not sent; later on, nothing. */
    private List<Cell> marked(List<Cell> cells) {
        int slice = difference.orElse(-1);
        List<Cell> marked =
                cells.stream()
                        .map(cell -> cell.with(cell.slice() == slice && !isAllowed(cell)))
                        .toList();
        return marked.stream().anyMatch(Cell::differs)
                ? marked
                : cells.stream().map(cell -> cell.with(cell.slice() == slice)).toList();
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
}
