package arcomat.simulate.run;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.component;
import static arcomat.semantics.ComponentBuilder.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.ComponentBuilder;
import arcomat.simulate.Runs;

import org.junit.jupiter.api.Test;

import java.util.Arrays;
import java.util.List;
import java.util.Map;

class InterpreterTest {
    /** Sends on what it receives. */
    private static Component pass(boolean instant) {
        ComponentBuilder builder = component(instant ? "Instant" : "Delayed").in(INTEGER, "i");
        builder = instant ? builder.instantOut(INTEGER, "o") : builder.out(INTEGER, "o");
        ComponentBuilder.AutomatonBuilder automaton =
                builder.automaton(Completion.IGNORE, "only").initial("only", "");
        return automaton
                .on("only", "", null, List.of(automaton.send("o", builder.read("i"))), List.of())
                .build();
    }

    private static Component chain(Component... links) {
        ComponentBuilder whole = component("Chain").in(INTEGER, "i").out(INTEGER, "o");
        for (int k = links.length - 1; k >= 0; k--) {
            whole.part("p" + k, links[k]);
            whole.connect(k == 0 ? "i" : "p" + (k - 1) + ".o", "p" + k + ".i");
        }
        return whole.connect("p" + (links.length - 1) + ".o", "o").build();
    }

    private static List<String> outputs(Component component, String... letters) {
        Trace trace = Runs.run(component, Choice.first(), letters);
        return trace.steps().stream().map(Runs::outputs).toList();
    }

    @Test
    void aMessageTakesASlicePerDelay() {
        String[] letters = {"i=1", "i=2", "", "i=4", "", ""};
        assertThat(outputs(chain(pass(true), pass(true)), letters))
                .containsExactly("o=1", "o=2", "", "o=4", "", "");
        assertThat(outputs(chain(pass(true), pass(false), pass(true)), letters))
                .containsExactly("", "o=1", "o=2", "", "o=4", "");
        assertThat(outputs(chain(pass(false), pass(false)), letters))
                .containsExactly("", "", "o=1", "o=2", "", "o=4");
        assertThat(outputs(chain(chain(pass(false)), chain(pass(true), pass(false))), letters))
                .containsExactly("", "", "o=1", "o=2", "", "o=4");
    }

    /** Two parts that feed each other through registers start with their initial outputs. */
    @Test
    void registersBreakACycle() {
        ComponentBuilder echo = component("Echo").in(INTEGER, "i").out(INTEGER, "o");
        ComponentBuilder.AutomatonBuilder automaton =
                echo.automaton(Completion.IGNORE, "only").initial("only", "o = 5");
        Component first =
                automaton
                        .on(
                                "only",
                                "i = ?",
                                null,
                                List.of(automaton.send("o", echo.read("i"))),
                                List.of())
                        .build();
        Component ring =
                component("Ring")
                        .out(INTEGER, "o")
                        .part("a", first)
                        .part("b", pass(false))
                        .connect("a.o", "b.i")
                        .connect("b.o", "a.i")
                        .connect("b.o", "o")
                        .build();
        assertThat(outputs(ring, "", "", "", "", "")).containsExactly("", "o=5", "", "o=5", "");
    }

    @Test
    void platformPortsAreReadAndShownByTheirPath() {
        Component light = component("Light").platform().instantOut(INTEGER, "value").build();
        Component motor = component("Motor").platform().in(INTEGER, "power").build();
        Component robot =
                component("Robot")
                        .part("left", light)
                        .part("control", pass(true))
                        .part("wheel", motor)
                        .connect("left.value", "control.i")
                        .connect("control.o", "wheel.power")
                        .build();
        Interpreter run = new Interpreter(robot, List.of(), Choice.first());
        Letter seen = Letter.of(Map.of("left.value", new Value.IntegerValue(40)));
        assertThat(Runs.outputs(run.step(seen))).isEqualTo("wheel.power=40");
        assertThat(Runs.outputs(run.step(Letter.SILENCE))).isEmpty();
        assertThatThrownBy(
                        () ->
                                run.step(
                                        Letter.of(
                                                Map.of(
                                                        "nose.value",
                                                        seen.message("left.value").get()))))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Robot has no input nose.value");
    }

    @Test
    void withoutBehaviourNothingIsSentButWhatHasToBe() {
        Component open =
                component("Open")
                        .in(INTEGER, "i")
                        .out(MOTOR, "cmd")
                        .totalOut(MOTOR, "always")
                        .build();
        assertThat(outputs(open, "i=1", "")).containsExactly("always=fwd", "always=fwd");
    }

    @Test
    void aConjunctionSendsWhatAllAutomataAllow() {
        assertThat(outputs(conjunction("stop"), "i=1", "")).containsExactly("cmd=fwd", "cmd=stop");
        Trace trace = Runs.run(conjunction("backRight"), Choice.first(), "i=1");
        assertThat(trace.failure())
                .hasValue(
                        "slice 0: Both: its automata contradict each other, no output satisfies"
                                + " all of them for this input");
    }

    /** The first automaton allows fwd or stop, the second one command only. */
    private static Component conjunction(String second) {
        return component("Both")
                .in(INTEGER, "i")
                .out(MOTOR, "cmd")
                .automaton(Completion.OUTPUT, "a")
                .initial("a", "cmd = fwd")
                .on("a", "i = ?", "cmd = fwd")
                .on("a", "i = ?", "cmd = stop")
                .end()
                .automaton(Completion.OUTPUT, "b")
                .initial("b", "cmd = fwd")
                .on("b", "i = ?", "cmd = " + second)
                .build();
    }

    @Test
    void severalInitialStatesAreAChoice() {
        Component two =
                component("Two")
                        .out(MOTOR, "cmd")
                        .automaton(Completion.IGNORE, "a", "b")
                        .initial("a", "cmd = fwd")
                        .initial("b", "cmd = stop")
                        .build();
        Trace trace =
                Runs.run(
                        two,
                        Choice.ask(
                                question -> {
                                    assertThat(question.alternatives())
                                            .containsExactly(
                                                    "initial a / cmd = fwd",
                                                    "initial b / cmd = stop");
                                    return 1;
                                }),
                        "");
        assertThat(Runs.lines(trace)).containsExactly("cmd=stop | b IGNORE b");
    }

    @Test
    void aValueFromOutsideItsRangeEndsTheRun() {
        Component ranged = component("Ranged").in(range(0, 9), "i").build();
        assertThat(Runs.run(ranged, Choice.first(), "i=9", "i=10").failure())
                .hasValue("slice 1: i = 10 from outside is not of type Integer[0..9]");
    }

    @Test
    void theSeedDecidesTheRun() {
        Component coin =
                component("Coin")
                        .in(BOOLEAN, "toss")
                        .instantOut(MOTOR, "cmd")
                        .automaton(Completion.IGNORE, "only")
                        .initial("only", "")
                        .on("only", "", "cmd = fwd")
                        .on("only", "", "cmd = stop")
                        .build();
        String[] letters = new String[64];
        Arrays.fill(letters, "");
        List<String> one = Runs.lines(Runs.run(coin, Choice.random(1), letters));
        assertThat(Runs.lines(Runs.run(coin, Choice.random(1), letters))).isEqualTo(one);
        assertThat(Runs.lines(Runs.run(coin, Choice.random(2), letters))).isNotEqualTo(one);
        assertThat(one.stream().filter(line -> line.startsWith("cmd=fwd")).count())
                .isBetween(16L, 48L);
    }
}
