package arcomat.simulate.test;

import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.component;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.CoffeeFigures;
import arcomat.semantics.ComponentBuilder;
import arcomat.simulate.Runs;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.test.StreamTestResult.Verdict;

import org.junit.jupiter.api.Test;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;

class StreamTestsTest {
    private static StreamTest test(
            Component component, List<Letter> inputs, String port, String... expected) {
        List<List<Value>> stream = new ArrayList<>();
        for (String slice : expected) {
            stream.add(
                    slice.isEmpty()
                            ? List.of()
                            : Arrays.stream(slice.split(","))
                                    .map(v -> value(component, port, v))
                                    .toList());
        }
        return new StreamTest(
                "Suite",
                "test",
                component,
                List.of(),
                inputs,
                Map.of(port, stream),
                ComponentBuilder.NOWHERE);
    }

    private static Value value(Component component, String port, String text) {
        return ComponentBuilder.value(component.port(port).orElseThrow().type(), text);
    }

    private static StreamTestResult figure3(
            Completion completion, List<String> letters, String... expected) {
        Component avoid = CoffeeFigures.figure3(completion);
        List<Letter> inputs = Runs.letters(avoid, letters.toArray(new String[0]));
        return StreamTests.run(test(avoid, inputs, "cmd", expected));
    }

    @Test
    void eachAlternativeIsAllowed() {
        List<String> tooClose = List.of("frontUS=tooClose");
        assertThat(figure3(Completion.IGNORE, tooClose, "fwd", "backRight").verdict())
                .isEqualTo(Verdict.PASSED);
        assertThat(figure3(Completion.IGNORE, tooClose, "fwd", "stop").verdict())
                .isEqualTo(Verdict.PASSED);
    }

    @Test
    void whatNoAlternativeSendsIsADifference() {
        StreamTestResult result =
                figure3(Completion.IGNORE, List.of("frontUS=tooClose"), "fwd", "fwd");
        assertThat(result.verdict()).isEqualTo(Verdict.FAILED);
        assertThat(result.firstDifference()).hasValue(1);
        StreamTestResult.Cell cell = result.cells().get(1);
        assertThat(cell.differs()).isTrue();
        assertThat(cell.allowed()).containsExactly("backRight", "stop");
        assertThat(cell.actual()).hasToString("[backRight]");
        assertThat(result.cells().get(0).differs()).isFalse();
    }

    /** Later outputs decide which alternative has been taken. */
    @Test
    void anAlternativeThatWasRuledOutDoesNotComeBack() {
        List<String> letters = List.of("frontUS=tooClose", "frontUS=clear");
        assertThat(figure3(Completion.IGNORE, letters, "fwd", "stop", "fwd").verdict())
                .isEqualTo(Verdict.PASSED);
        StreamTestResult other = figure3(Completion.IGNORE, letters, "fwd", "backRight", "fwd");
        assertThat(other.verdict()).isEqualTo(Verdict.FAILED);
        assertThat(other.firstDifference()).hasValue(2);
    }

    @Test
    void whatOnlyChaosAllowsIsVacuous() {
        List<String> letters = List.of("frontUS=tooClose", "", "frontUS=clear");
        StreamTestResult result =
                figure3(Completion.CHAOS, letters, "fwd", "stop", "backRight", "fwd");
        assertThat(result.verdict()).isEqualTo(Verdict.VACUOUS);
        assertThat(result.vacuousFrom()).hasValue(2);
        assertThat(figure3(Completion.OUTPUT, letters, "fwd", "stop", "backRight", "fwd").verdict())
                .isEqualTo(Verdict.PASSED);
        assertThat(figure3(Completion.IGNORE, letters, "fwd", "stop", "backRight", "fwd").verdict())
                .isEqualTo(Verdict.FAILED);
    }

    @Test
    void aForbiddenInputFails() {
        StreamTestResult result = figure3(Completion.ERROR, List.of("frontUS=clear"), "fwd", "");
        assertThat(result.verdict()).isEqualTo(Verdict.FAILED);
        assertThat(result.failure()).hasValueSatisfying(f -> assertThat(f).contains("forbids"));
    }

    /** The slice after the inputs shows what was sent before, also where it goes wrong. */
    @Test
    void anExecutionThatErrsHasShownWhatItSent() {
        Component avoid = CoffeeFigures.figure3(Completion.ERROR);
        List<Letter> letters = Runs.letters(avoid, "frontUS=tooClose");
        StreamTest test = test(avoid, letters, "cmd", "fwd", "backRight");
        List<Letter> longer = Runs.letters(avoid, "frontUS=tooClose", "");
        assertThat(Simulation.run(first(avoid), longer).end()).isPresent();
        assertThat(ExecutedTests.run(test, first(avoid)).verdict()).isEqualTo(Verdict.PASSED);
        StreamTest other = test(avoid, letters, "cmd", "fwd", "fwd");
        assertThat(ExecutedTests.run(other, first(avoid)).verdict()).isEqualTo(Verdict.FAILED);
    }

    @Test
    void anAbsentTotalInputFails() {
        Component avoid = CoffeeFigures.figure6(Completion.IGNORE, true);
        StreamTestResult result =
                StreamTests.run(test(avoid, Runs.letters(avoid, ""), "cmd", "fwd", ""));
        assertThat(result.verdict()).isEqualTo(Verdict.FAILED);
        assertThat(result.failure())
                .hasValue("slice 0: no message on gotCoffee, which is <<total>>");
    }

    @Test
    void aChoiceInsideANetworkIsFollowedThroughItsReaders() {
        Component chooser =
                component("Chooser")
                        .in(INTEGER, "i")
                        .out(INTEGER, "o")
                        .automaton(Completion.IGNORE, "a", "b", "c")
                        .initial("a", "")
                        .on("a -> b", "i = ?", "o = 1")
                        .on("a -> c", "i = ?", "o = 2")
                        .build();
        Component reader =
                component("Reader")
                        .in(INTEGER, "i")
                        .instantOut(MOTOR, "cmd")
                        .automaton(Completion.IGNORE, "only")
                        .initial("only", "")
                        .on("only", "i = 1", "cmd = fwd")
                        .on("only", "i = 2", "cmd = stop")
                        .build();
        Component whole =
                component("Whole")
                        .in(INTEGER, "i")
                        .out(MOTOR, "cmd")
                        .part("reader", reader)
                        .part("chooser", chooser)
                        .connect("i", "chooser.i")
                        .connect("chooser.o", "reader.i")
                        .connect("reader.cmd", "cmd")
                        .build();
        List<Letter> letters = Runs.letters(whole, "i=7", "");
        assertThat(StreamTests.run(test(whole, letters, "cmd", "", "fwd")).verdict())
                .isEqualTo(Verdict.PASSED);
        assertThat(StreamTests.run(test(whole, letters, "cmd", "", "stop")).verdict())
                .isEqualTo(Verdict.PASSED);
        assertThat(StreamTests.run(test(whole, letters, "cmd", "", "backRight")).verdict())
                .isEqualTo(Verdict.FAILED);
    }

    @Test
    void compiledCodeHasToSendJustWhatIsExpected() {
        Component avoid = CoffeeFigures.figure3(Completion.IGNORE);
        List<Letter> inputs = Runs.letters(avoid, "frontUS=tooClose");
        StreamTest stop = test(avoid, inputs, "cmd", "fwd", "stop");
        StreamTest back = test(avoid, inputs, "cmd", "fwd", "backRight");
        assertThat(ExecutedTests.run(stop, first(avoid)).firstDifference()).hasValue(1);
        assertThat(ExecutedTests.run(back, first(avoid)).verdict()).isEqualTo(Verdict.PASSED);
    }

    private static Interpreter first(Component component) {
        return new Interpreter(component, List.of(), Choice.first());
    }

    @Test
    void eventDrivenTestsTryEveryChoice() {
        Component chooser =
                component("Chooser")
                        .eventDriven()
                        .in(INTEGER, "i")
                        .out(INTEGER, "o")
                        .automaton(Completion.CHAOS, "a", "b")
                        .initial("a", "o = 0")
                        .on("a -> a", "i = 1", "o = 1|1")
                        .on("a -> b", "i = 1", "o = 2")
                        .build();
        List<Letter> letters = Runs.letters(chooser, "i=1", "i=1");
        assertThat(StreamTests.run(test(chooser, letters, "o", "0,1,1,2")).verdict())
                .isEqualTo(Verdict.PASSED);
        assertThat(StreamTests.run(test(chooser, letters, "o", "0,2")).verdict())
                .isEqualTo(Verdict.VACUOUS);
        StreamTestResult open = StreamTests.run(test(chooser, letters, "o", "0,2,7,7"));
        assertThat(open.verdict()).isEqualTo(Verdict.VACUOUS);
        assertThat(open.vacuousFrom()).hasValue(1);
        StreamTestResult failed = StreamTests.run(test(chooser, letters, "o", "0,1,2,2"));
        assertThat(failed.verdict()).isEqualTo(Verdict.FAILED);
        assertThat(failed.firstDifference()).hasValue(2);
    }
}
