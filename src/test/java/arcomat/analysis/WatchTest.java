package arcomat.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.RandomPairs.Pair;
import arcomat.analysis.Verdict.Answer;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.FirstValue;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Sent;
import arcomat.simulate.Choice;
import arcomat.simulate.Interpreter;
import arcomat.simulate.Simulation;
import arcomat.simulate.Violation;
import arcomat.simulate.Watch;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Watching and proving agree: runs of what refines a requirement keep it, and a counterexample
 * violates it in its last slice, not before.
 */
class WatchTest {
    private static final int PAIRS = 400;
    private static final Budget BUDGET = new Budget(() -> false, 100_000);

    /** What the ports show in a slice. */
    private record Slice(Letter inputs, Letter outputs) {}

    @Test
    void agreesWithRefinement() {
        int held = 0;
        int failed = 0;
        for (Pair pair : RandomPairs.any(11, PAIRS)) {
            Component left = pair.left().component();
            Component right = pair.right().component();
            Verdict verdict = Refinement.check(pair.left(), pair.right(), BUDGET);
            if (verdict.answer() == Answer.HOLDS) {
                held++;
                assertThat(violation(right, run(left, held))).isEmpty();
            } else if (!verdict.trace().isEmpty() && !forbids(left)) {
                failed++;
                List<Slice> slices = slices(verdict.trace(), right);
                int last = slices.size() - 1;
                int seen = violation(right, slices).map(Violation::slice).orElseThrow();
                assertThat(seen).isBetween(forbids(right) ? last - 1 : last, last);
            }
        }
        assertThat(held).isGreaterThan(PAIRS / 5);
        assertThat(failed).isGreaterThan(PAIRS / 5);
    }

    /** A run may end in an error, which nobody sees; a forbidden input counts when it comes. */
    private static boolean forbids(Component component) {
        return component.automata().get(0).completion() == Automaton.Completion.ERROR;
    }

    private static Optional<Violation> violation(Component required, List<Slice> slices) {
        Watch watch = new Watch(required, required.automata().get(0), List.of());
        Optional<Violation> found = Optional.empty();
        for (Slice slice : slices) {
            found = found.or(() -> watch.see(slice.inputs, slice.outputs));
        }
        return found;
    }

    private static List<Slice> run(Component component, int seed) {
        Interpreter interpreter =
                new Interpreter(component, List.of(), Choice.randomThroughout(seed));
        Trace trace =
                Simulation.run(
                        interpreter, Simulation.randomLetters(interpreter.network(), seed, 20, 60));
        return trace.steps().stream()
                .map(step -> new Slice(step.inputs(), step.outputs()))
                .toList();
    }

    /** From inputs with their reactions to what is seen together. */
    private static List<Slice> slices(List<Moment> moments, Component component) {
        boolean delayed = component.outputs().get(0).delay() > 0;
        List<Slice> slices = new ArrayList<>();
        for (int i = delayed ? 0 : 1; i < moments.size(); i++) {
            int input = delayed ? i + 1 : i;
            Letter inputs =
                    input < moments.size() ? moments.get(input).input() : silence(component);
            slices.add(new Slice(inputs, outputs(moments.get(i), component)));
        }
        return slices;
    }

    /** No input is read any more; the slice only shows the last reaction. */
    private static Letter silence(Component component) {
        Map<String, Value> totals = new LinkedHashMap<>();
        for (Port port : component.inputs()) {
            if (port.total()) {
                totals.put(port.name(), FirstValue.of(port.type()));
            }
        }
        return Letter.of(totals);
    }

    private static Letter outputs(Moment moment, Component component) {
        Map<String, List<Value>> messages = new LinkedHashMap<>();
        for (Port port : component.outputs()) {
            Sent sent = moment.outputs().getOrDefault(port.name(), Sent.SILENCE);
            if (sent instanceof Sent.Messages certain) {
                messages.put(port.name(), certain.values());
            } else if (!sent.allows(List.of())) {
                messages.put(port.name(), List.of(FirstValue.of(port.type())));
            }
        }
        return new Letter(messages);
    }
}
