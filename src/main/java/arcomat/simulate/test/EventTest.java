package arcomat.simulate.test;

import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Surroundings;
import arcomat.simulate.test.AllowedBehaviour.Standing;
import arcomat.simulate.test.StreamTestResult.Cell;
import arcomat.simulate.test.StreamTestResult.Verdict;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;

/** A stream test of an event-driven component against all that its model allows. */
final class EventTest {
    private final StreamTest test;
    private Optional<String> gaveUp = Optional.empty();

    EventTest(StreamTest test) {
        this.test = test;
    }

    StreamTestResult run() {
        Optional<PossibleRun> best;
        try {
            AllowedEvents allowed = allowed(test);
            best =
                    runs(allowed).stream()
                            .filter(allowed::isComplete)
                            .reduce((one, two) -> two.isBetterThan(one) ? two : one);
            gaveUp = allowed.gaveUp();
        } catch (ModelError problem) {
            return failed(Optional.of(String.valueOf(problem.getMessage())));
        }
        if (best.isEmpty()) {
            return gaveUp.isPresent() ? passing(Verdict.UNKNOWN, gaveUp) : failed(problem());
        }
        return best.get().standing == Standing.SURE
                ? passing(Verdict.PASSED, Optional.empty())
                : vacuous(best.get());
    }

    private static AllowedEvents allowed(StreamTest test) {
        Network network = Network.of(test.component(), test.arguments());
        return new AllowedEvents(network, test, StreamTests.mentioned(test));
    }

    /** Those that go on to the end of the test and show the beginnings of what is expected. */
    private Collection<PossibleRun> runs(AllowedEvents allowed) {
        Surroundings surroundings = new Surroundings(allowed.network);
        Collection<PossibleRun> runs = allowed.starts();
        List<Letter> letters = StreamTests.letters(test, test.component());
        for (int event = 0; event < letters.size() && !runs.isEmpty(); event++) {
            surroundings.requireKnownPorts(letters.get(event));
            runs = allowed.event(runs, letters.get(event), event);
        }
        return runs;
    }

    /** Why no run goes on to the end, whatever it shows; empty if one does. */
    private Optional<String> problem() {
        AllowedEvents allowed = allowed(test.expecting(Map.of()));
        return runs(allowed).isEmpty() && allowed.gaveUp().isEmpty()
                ? allowed.lastProblem()
                : Optional.empty();
    }

    private StreamTestResult vacuous(PossibleRun best) {
        Network network = Network.of(test.component(), test.arguments());
        return passing(
                Verdict.VACUOUS,
                OptionalInt.of(best.since),
                best.chaotic < 0
                        ? AllowedBehaviour.chaosSomewhere(network)
                        : AllowedBehaviour.chaos(network, best.chaotic, best.configurations),
                Optional.empty());
    }

    private StreamTestResult passing(Verdict verdict, Optional<String> reason) {
        return passing(verdict, OptionalInt.empty(), "", reason);
    }

    private StreamTestResult passing(
            Verdict verdict, OptionalInt vacuousFrom, String chaotic, Optional<String> reason) {
        List<Cell> cells =
                StreamTests.cells(test, StreamTests.firstRun(test), List.of()).stream()
                        .map(cell -> cell.with(false))
                        .toList();
        return new StreamTestResult(
                test, verdict, cells, OptionalInt.empty(), vacuousFrom, chaotic, reason);
    }

    private StreamTestResult failed(Optional<String> problem) {
        Trace first = StreamTests.firstRun(test);
        List<Cell> cells = StreamTests.cells(test, first, List.of());
        OptionalInt difference = cells.stream().filter(Cell::differs).mapToInt(Cell::slice).min();
        return new StreamTestResult(
                test,
                Verdict.FAILED,
                cells,
                difference,
                OptionalInt.empty(),
                "",
                reason(first, problem));
    }

    /** A run that goes wrong is no reason where others go on. */
    private static Optional<String> reason(Trace first, Optional<String> problem) {
        if (problem.isPresent()) {
            return first.failure().or(() -> problem);
        }
        return first.failure()
                .map(end -> "no run shows what is expected; the first one ends: " + end);
    }
}
