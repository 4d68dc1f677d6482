package arcomat.simulate;

import static arcomat.semantics.CoffeeFigures.figure3;
import static arcomat.semantics.CoffeeFigures.figure5;
import static arcomat.semantics.CoffeeFigures.figure6;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Trace;
import arcomat.simulate.run.Choice;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.List;

class CoffeeRunsTest {
    private static List<String> first(Component component, String... letters) {
        return Runs.lines(Runs.run(component, Choice.first(), letters));
    }

    @Test
    void figure3SidestepsWhenTheFirstTransitionIsTaken() {
        assertThat(first(figure3(Completion.IGNORE), "frontUS=tooClose", "frontUS=clear", ""))
                .containsExactly(
                        "cmd=fwd | driving t0 sidestep",
                        "cmd=backRight | sidestep IGNORE sidestep",
                        " | sidestep IGNORE sidestep");
    }

    @Test
    void figure3WaitsWhenTheSecondIsAskedFor() {
        Choice second = Choice.ask(question -> 1);
        Trace trace =
                Runs.run(
                        figure3(Completion.IGNORE),
                        second,
                        "frontUS=tooClose",
                        "frontUS=tooClose",
                        "frontUS=clear",
                        "");
        assertThat(Runs.lines(trace))
                .containsExactly(
                        "cmd=fwd | driving t1 waiting",
                        "cmd=stop | waiting IGNORE waiting",
                        " | waiting t2 driving",
                        "cmd=fwd | driving IGNORE driving");
    }

    @Test
    void aQuestionDescribesItsAlternatives() {
        Choice asked =
                Choice.ask(
                        question -> {
                            assertThat(question.step()).isZero();
                            assertThat(question.alternatives())
                                    .containsExactly(
                                            "driving -> sidestep (line 1)",
                                            "driving -> waiting (line 1)");
                            return 1;
                        });
        Trace trace = Runs.run(figure3(Completion.CHAOS), asked, "frontUS=tooClose");
        assertThat(Runs.lines(trace)).containsExactly("cmd=fwd | driving t1 waiting");
    }

    @Test
    void figure5ComesBackAfterTheAlert() {
        assertThat(
                        first(
                                figure5(Completion.IGNORE),
                                "",
                                "frontUS=tooClose",
                                "frontUS=clear",
                                "timerSig=alert",
                                "frontUS=clear",
                                ""))
                .containsExactly(
                        "cmd=fwd | driving IGNORE driving",
                        " | driving t0 backing",
                        "cmd=backRight timerCmd=delay | backing IGNORE backing",
                        " | backing t3 remote",
                        "cmd=stop | remote t4 returning",
                        "cmd=fwd | returning IGNORE returning");
    }

    @Test
    void figure6DecidesByCoffee() {
        Component avoid = figure6(Completion.OUTPUT, true);
        assertThat(
                        first(
                                avoid,
                                "gotCoffee=true frontUS=tooClose",
                                "gotCoffee=true frontUS=clear",
                                "gotCoffee=false frontUS=tooClose",
                                "gotCoffee=false timerSig=alert",
                                "gotCoffee=false frontUS=clear",
                                "gotCoffee=false ls=ok",
                                "gotCoffee=false"))
                .containsExactly(
                        "cmd=fwd | driving t1 waiting",
                        "cmd=stop | waiting t2 driving",
                        "cmd=fwd | driving t0 backing",
                        "cmd=backRight timerCmd=delay | backing t3 remote",
                        "cmd=stop | remote t4 returning",
                        "cmd=fwd | returning t5 driving",
                        " | driving OUTPUT driving");
    }

    @Test
    void withoutACoffeeMessageNeitherTransitionOfFigure6IsEnabled() {
        assertThat(first(figure6(Completion.CHAOS, false), "frontUS=tooClose", ""))
                .containsExactly("cmd=fwd | driving CHAOS driving", " | driving CHAOS driving");
    }

    @Test
    void anAbsentTotalInputEndsTheRun() {
        assertThat(
                        first(
                                figure6(Completion.CHAOS, true),
                                "gotCoffee=false",
                                "frontUS=tooClose",
                                "gotCoffee=false"))
                .containsExactly(
                        "cmd=fwd | driving CHAOS driving",
                        "! slice 1: no message on gotCoffee, which is <<total>>");
    }

    @Test
    void aForbiddenInputEndsTheRun() {
        assertThat(first(figure3(Completion.ERROR), "frontUS=tooClose", "frontUS=tooClose"))
                .containsExactly(
                        "cmd=fwd | driving t0 sidestep",
                        "! slice 1: AvoidCrash3, in sidestep: the automaton forbids this input");
    }

    @ParameterizedTest
    @EnumSource(
            value = Completion.class,
            names = {"CHAOS", "OUTPUT", "IGNORE"})
    void completionsKeepTheStateAndSendNothing(Completion completion) {
        assertThat(first(figure3(completion), "", "", "frontUS=tooClose", ""))
                .containsExactly(
                        "cmd=fwd | driving " + completion + " driving",
                        " | driving " + completion + " driving",
                        " | driving t0 sidestep",
                        "cmd=backRight | sidestep " + completion + " sidestep");
    }
}
