package arcomat.simulate.test;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.rt.ModelError;
import arcomat.semantics.network.Network;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Cell;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Runs stream tests. Against a model, a test passes if what it expects is among the outputs that
 * the model allows, all choices considered.
 */
public final class StreamTests {
    private StreamTests() {}

    /** Runs a test against the model of its component. */
    public static StreamTestResult run(StreamTest test) {
        return isTimed(test) ? new SliceTest(test).run() : new EventTest(test).run();
    }

    static boolean isTimed(StreamTest test) {
        return test.component().profile() == Component.Profile.TIME_SYNCHRONOUS;
    }

    /** The length of the longest expected stream. */
    static int length(StreamTest test) {
        return test.expected().values().stream().mapToInt(List::size).max().orElse(0);
    }

    /** All messages of the test. */
    static List<Value> mentioned(StreamTest test) {
        Stream<List<Value>> read =
                test.inputs().stream().flatMap(letter -> letter.messages().values().stream());
        Stream<List<Value>> expected = test.expected().values().stream().flatMap(List::stream);
        return Stream.concat(read, expected).flatMap(List::stream).distinct().toList();
    }

    /** A run over the inputs of a test, with the first choice wherever the model leaves one. */
    public static Trace firstRun(StreamTest test) {
        return firstRun(test, false);
    }

    /**
     * As above.
     *
     * @param explaining whether it tells why no transition fired where none did
     */
    public static Trace firstRun(StreamTest test, boolean explaining) {
        try {
            Interpreter interpreter =
                    new Interpreter(test.component(), test.arguments(), Choice.first());
            return Simulation.run(
                    explaining ? interpreter.explaining() : interpreter,
                    letters(test, test.component()));
        } catch (ModelError error) {
            return new Trace(
                    test.component(), List.of(), Optional.of(String.valueOf(error.getMessage())));
        }
    }

    /**
     * The inputs, and one letter more where the test looks at the slice after them: what is seen
     * there was sent before, so the letter repeats the messages of total ports and is silent
     * otherwise.
     */
    static List<Letter> letters(StreamTest test, Component component) {
        List<Letter> letters = new ArrayList<>(test.inputs());
        if (!isTimed(test)) {
            return letters.isEmpty() ? List.of(Letter.SILENCE) : letters;
        }
        if (length(test) > letters.size()) {
            Network network = Network.of(component, test.arguments());
            letters.add(quietAfter(letters, network));
        }
        return letters;
    }

    /**
     * A letter that adds nothing to what went before: total ports repeat their last message, the
     * others are silent.
     */
    public static Letter quietAfter(List<Letter> letters, Network network) {
        Letter last = letters.isEmpty() ? Letter.SILENCE : letters.get(letters.size() - 1);
        Map<String, Value> totals = new LinkedHashMap<>();
        for (Network.External input : network.inputs()) {
            if (input.port().total()) {
                last.message(input.name()).ifPresent(value -> totals.put(input.name(), value));
            }
        }
        return Letter.of(totals);
    }

    /**
     * Lays expected, actual and allowed streams side by side.
     *
     * @param allowed per slice, per port the allowed outputs; may be shorter than the test
     */
    static List<Cell> cells(
            StreamTest test, Trace actual, List<Map<String, List<String>>> allowed) {
        return isTimed(test) ? sliceCells(test, actual, allowed) : eventCells(test, actual);
    }

    private static List<Cell> sliceCells(
            StreamTest test, Trace actual, List<Map<String, List<String>>> allowed) {
        List<Cell> cells = new ArrayList<>();
        for (int slice = 0; slice < length(test); slice++) {
            for (Map.Entry<String, List<List<Value>>> entry : test.expected().entrySet()) {
                if (slice < entry.getValue().size()) {
                    List<Value> expected = entry.getValue().get(slice);
                    List<Value> sent = messages(actual, slice, entry.getKey());
                    List<String> open =
                            slice < allowed.size()
                                    ? allowed.get(slice).getOrDefault(entry.getKey(), List.of())
                                    : List.of();
                    boolean differs = slice >= actual.shown().size() || !expected.equals(sent);
                    cells.add(new Cell(slice, entry.getKey(), expected, sent, open, differs));
                }
            }
        }
        return cells;
    }

    private static List<Value> messages(Trace trace, int slice, String port) {
        return slice < trace.shown().size() ? trace.shown().get(slice).messages(port) : List.of();
    }

    private static List<Cell> eventCells(StreamTest test, Trace actual) {
        List<Cell> cells = new ArrayList<>();
        for (Map.Entry<String, List<List<Value>>> entry : test.expected().entrySet()) {
            List<Value> expected = entry.getValue().stream().flatMap(List::stream).toList();
            List<Value> sent = stream(actual, entry.getKey());
            for (int i = 0; i < Math.max(expected.size(), sent.size()); i++) {
                List<Value> left = i < expected.size() ? List.of(expected.get(i)) : List.of();
                List<Value> right = i < sent.size() ? List.of(sent.get(i)) : List.of();
                boolean differs = !left.equals(right);
                cells.add(new Cell(i, entry.getKey(), left, right, List.of(), differs));
            }
        }
        return cells;
    }

    /** All messages on a port, in order. */
    static List<Value> stream(Trace trace, String port) {
        return trace.steps().stream()
                .flatMap(step -> step.outputs().messages(port).stream())
                .toList();
    }
}
