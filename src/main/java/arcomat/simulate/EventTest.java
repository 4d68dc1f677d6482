package arcomat.simulate;

import arcomat.model.Automaton.Completion;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.simulate.StreamTestResult.Cell;
import arcomat.simulate.StreamTestResult.Verdict;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/**
 * A stream test of an event-driven component: every sequence of choices is tried, one run each.
 * Messages that a completion leaves open are not sent in these runs.
 */
final class EventTest {
    private static final int MOST_RUNS = 10_000;

    /** Follows a script of choices, the first alternative after its end, and notes the counts. */
    private static final class Script implements Choice {
        private final List<Integer> picks = new ArrayList<>();
        private final List<Integer> counts = new ArrayList<>();
        private int position;

        @Override
        public int pick(Question question) {
            if (position == picks.size()) {
                picks.add(0);
                counts.add(question.count());
            }
            return picks.get(position++);
        }

        @Override
        public Optional<Value> message(Port port, boolean required) {
            return Choice.first().message(port, required);
        }

        /** Turns to the next sequence of choices; false after the last. */
        boolean advance() {
            position = 0;
            while (!picks.isEmpty()) {
                int last = picks.size() - 1;
                if (picks.get(last) + 1 < counts.get(last)) {
                    picks.set(last, picks.get(last) + 1);
                    return true;
                }
                picks.remove(last);
                counts.remove(last);
            }
            return false;
        }
    }

    private final StreamTest test;

    EventTest(StreamTest test) {
        this.test = test;
    }

    StreamTestResult run() {
        Script script = new Script();
        Trace first = null;
        Trace vacuous = null;
        int runs = 0;
        do {
            Trace trace = trace(script);
            first = first == null ? trace : first;
            if (agrees(trace)) {
                if (chaosFrom(trace).isEmpty()) {
                    return result(trace, Verdict.PASSED, trace.failure());
                }
                vacuous = trace;
            }
            if (++runs > MOST_RUNS) {
                String problem = "more than " + MOST_RUNS + " possible runs";
                return result(first, Verdict.FAILED, Optional.of(problem));
            }
        } while (script.advance());
        return vacuous != null
                ? result(vacuous, Verdict.VACUOUS, Optional.empty())
                : result(first, Verdict.FAILED, first.failure());
    }

    private Trace trace(Script script) {
        Interpreter interpreter = new Interpreter(test.component(), test.arguments(), script);
        return Simulation.run(interpreter, StreamTests.letters(test, test.component()));
    }

    private boolean agrees(Trace trace) {
        return trace.failure().isEmpty()
                && StreamTests.cells(test, trace, List.of()).stream().noneMatch(Cell::differs);
    }

    private static OptionalInt chaosFrom(Trace trace) {
        return trace.steps().stream()
                .filter(step -> step.activities().stream().anyMatch(EventTest::isChaos))
                .mapToInt(Trace.Step::number)
                .findFirst();
    }

    private static boolean isChaos(Trace.Activity activity) {
        return activity.cause().equals(new Trace.Completed(Completion.CHAOS));
    }

    private StreamTestResult result(Trace trace, Verdict verdict, Optional<String> failure) {
        List<Cell> cells = StreamTests.cells(test, trace, List.of());
        OptionalInt difference = cells.stream().filter(Cell::differs).mapToInt(Cell::slice).min();
        OptionalInt chaos = verdict == Verdict.VACUOUS ? chaosFrom(trace) : OptionalInt.empty();
        return new StreamTestResult(test, verdict, cells, difference, chaos, failure);
    }
}
