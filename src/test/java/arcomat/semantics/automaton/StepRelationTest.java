package arcomat.semantics.automaton;

import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.MOTOR;
import static arcomat.semantics.ComponentBuilder.NOWHERE;
import static arcomat.semantics.ComponentBuilder.component;
import static arcomat.semantics.ComponentBuilder.constant;
import static arcomat.semantics.ComponentBuilder.range;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Letter;
import arcomat.model.Parameter;
import arcomat.model.Value;
import arcomat.semantics.CoffeeFigures;
import arcomat.semantics.ComponentBuilder;
import arcomat.semantics.Expressions;
import arcomat.semantics.automaton.StepRelation.Reaction;
import arcomat.semantics.automaton.StepRelation.Start;
import arcomat.semantics.expression.Arguments;
import arcomat.semantics.expression.Sent;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

class StepRelationTest {
    private static StepRelation sole(Component component) {
        return ComponentSemantics.of(component, List.of()).relations().get(0);
    }

    private static List<String> reactions(Component component, String port, String message) {
        StepRelation relation = sole(component);
        Configuration start = relation.starts().get(0).configuration();
        StepRelation.Prospect prospect = relation.prospect(start, input(component, port, message));
        return Stream.concat(
                        prospect.reactions().stream().map(r -> r.output().ports() + " " + r.next()),
                        prospect.errors().stream().map(error -> "error: " + error.message()))
                .toList();
    }

    private static Input input(Component component, String port, String message) {
        Letter letter =
                message.isEmpty()
                        ? Letter.SILENCE
                        : Letter.of(
                                Map.of(
                                        port,
                                        ComponentBuilder.value(
                                                component.port(port).orElseThrow().type(),
                                                message)));
        return Input.of(component, letter);
    }

    @Test
    void overlappingTransitionsAreAlternatives() {
        assertThat(reactions(CoffeeFigures.figure3(Completion.CHAOS), "frontUS", "tooClose"))
                .containsExactly("[backRight] 1[]", "[stop] 2[]");
    }

    @Test
    void eachCompletionHasItsStep() {
        assertThat(reactions(CoffeeFigures.figure3(Completion.CHAOS), "frontUS", "clear"))
                .containsExactly("[anything] chaos");
        assertThat(reactions(CoffeeFigures.figure3(Completion.OUTPUT), "frontUS", "clear"))
                .containsExactly("[anything] 0[]");
        assertThat(reactions(CoffeeFigures.figure3(Completion.IGNORE), "frontUS", ""))
                .containsExactly("[--] 0[]");
        assertThat(reactions(CoffeeFigures.figure3(Completion.ERROR), "frontUS", ""))
                .singleElement(STRING)
                .startsWith("error: ")
                .endsWith("the automaton forbids this input");
    }

    @Test
    void inputsAreWhatTheyCarry() {
        Component avoid = CoffeeFigures.figure3(Completion.CHAOS);
        assertThat(input(avoid, "frontUS", "clear")).isEqualTo(input(avoid, "frontUS", "clear"));
        assertThat(input(avoid, "frontUS", "clear")).isNotEqualTo(input(avoid, "frontUS", ""));
    }

    @Test
    void aConditionThatIsUndefinedOrGoesWrongDoesNotHold() {
        ComponentBuilder builder = component("C").in(INTEGER, "i");
        Component component = builder.automaton(Completion.CHAOS, "s").initial("s", "").build();
        Expression quotient =
                new Expression.Binary(
                        Expression.BinaryOperator.DIVIDE,
                        constant(INTEGER, "4"),
                        builder.read("i"),
                        INTEGER,
                        NOWHERE);
        Expression isTwo =
                Expressions.binary(
                        Expression.BinaryOperator.EQUAL, quotient, constant(INTEGER, "2"));
        StepRelation relation = sole(component);
        Configuration start = relation.starts().get(0).configuration();
        assertThat(List.of("2", "4", "0", ""))
                .filteredOn(
                        message ->
                                relation.condition(isTwo)
                                        .test(start, input(component, "i", message)))
                .containsExactly("2");
    }

    @Test
    void argumentsThatAreNotGivenHaveDefaults() {
        Parameter one = new Parameter("one", INTEGER, Optional.of(constant(INTEGER, "1")));
        Expression plusOne =
                new Expression.Binary(
                        Expression.BinaryOperator.PLUS,
                        new Expression.ParameterRead(one, NOWHERE),
                        constant(INTEGER, "1"),
                        INTEGER,
                        NOWHERE);
        Component component =
                component("C")
                        .parameter(one)
                        .parameter(new Parameter("next", INTEGER, Optional.of(plusOne)))
                        .build();
        assertThat(Arguments.complete(component, List.of())).hasToString("[1, 2]");
        assertThat(Arguments.complete(component, List.of(new Value.IntegerValue(5))))
                .hasToString("[5, 6]");
    }

    @Test
    void chaosAndErrorStay() {
        Component avoid = CoffeeFigures.figure3(Completion.CHAOS);
        for (Configuration top : List.of(Configuration.CHAOS, Configuration.ERROR)) {
            assertThat(sole(avoid).complete(top).next()).isEqualTo(top);
        }
        assertThat(
                        sole(avoid)
                                .prospect(Configuration.CHAOS, input(avoid, "frontUS", "clear"))
                                .reactions())
                .extracting(Reaction::next)
                .containsExactly(Configuration.CHAOS);
    }

    @Test
    void anOmittedPortIsSilentOrFree() {
        ComponentBuilder builder =
                component("Omits").in(INTEGER, "i").out(MOTOR, "cmd").totalOut(MOTOR, "always");
        Component free =
                builder.automaton(Completion.CHAOS, "only")
                        .free()
                        .initial("only", "always = fwd")
                        .on("only", "i = ?", "")
                        .build();
        assertThat(reactions(free, "i", "1")).containsExactly("[anything, ?] 0[]");
    }

    @Test
    void severalAutomataDecideOnlyAboutPortsThatTheyWrite() {
        Component both =
                component("Both")
                        .in(INTEGER, "i")
                        .out(MOTOR, "left")
                        .out(MOTOR, "right")
                        .automaton(Completion.OUTPUT, "a")
                        .initial("a", "")
                        .on("a", "i = 1", "left = fwd")
                        .end()
                        .automaton(Completion.OUTPUT, "b")
                        .initial("b", "")
                        .on("b", "i = ?", "right = stop")
                        .on("b", "i = 2", "right = fwd")
                        .build();
        ComponentSemantics behaviour = ComponentSemantics.of(both, List.of());
        List<Configuration> start =
                behaviour.starts().get(0).starts().stream().map(Start::configuration).toList();
        assertThat(behaviour.prospect(start, input(both, "i", "1")).reactions())
                .extracting(reaction -> reaction.output().toString())
                .containsExactly("Output[ports=[fwd, stop]]");
        assertThat(behaviour.prospect(start, input(both, "i", "2")).reactions())
                .extracting(reaction -> reaction.output().toString())
                .containsExactly("Output[ports=[anything, stop]]", "Output[ports=[anything, fwd]]");
    }

    @Test
    void contradictingAutomataHaveNoStep() {
        Component both =
                component("Both")
                        .in(INTEGER, "i")
                        .out(MOTOR, "cmd")
                        .automaton(Completion.OUTPUT, "a")
                        .initial("a", "cmd = fwd")
                        .on("a", "i = ?", "cmd = stop")
                        .end()
                        .automaton(Completion.OUTPUT, "b")
                        .initial("b", "cmd = fwd")
                        .on("b", "i = 1", "cmd = fwd")
                        .build();
        ComponentSemantics behaviour = ComponentSemantics.of(both, List.of());
        List<Configuration> start =
                behaviour.starts().get(0).starts().stream().map(Start::configuration).toList();
        assertThat(behaviour.prospect(start, input(both, "i", "1")).reactions()).isEmpty();
        assertThat(behaviour.prospect(start, input(both, "i", "2")).reactions()).hasSize(1);
    }

    @Test
    void aTransitionThatSendsAnAbsentMessageIsNotEnabled() {
        ComponentBuilder builder = component("Copy").in(INTEGER, "i").out(INTEGER, "o");
        Expression read = builder.read("i");
        ComponentBuilder.AutomatonBuilder automaton =
                builder.automaton(Completion.IGNORE, "only").initial("only", "");
        Component copy =
                automaton
                        .on("only", "", null, List.of(automaton.send("o", read)), List.of())
                        .build();
        assertThat(reactions(copy, "i", "7")).containsExactly("[7] 0[]");
        assertThat(reactions(copy, "i", "")).containsExactly("[--] 0[]");
    }

    /** Variables are exchanged, not copied one over the other. */
    @Test
    void rightHandSidesReadTheOldConfiguration() {
        ComponentBuilder builder = component("Swap").in(INTEGER, "i").out(INTEGER, "o");
        ComponentBuilder.AutomatonBuilder automaton =
                builder.automaton(Completion.IGNORE, "only")
                        .variable(INTEGER, "a", "1")
                        .variable(INTEGER, "b", "2")
                        .initial("only", "");
        Component swap =
                automaton
                        .on(
                                "only",
                                "i = ?",
                                null,
                                List.of(automaton.send("o", automaton.variable("a"))),
                                List.of(
                                        automaton.assign("a", automaton.variable("b")),
                                        automaton.assign("b", automaton.variable("a"))))
                        .build();
        assertThat(reactions(swap, "i", "0")).containsExactly("[1] 0[2, 1]");
    }

    private static Component calculating(Expression.BinaryOperator operator, String operand) {
        ComponentBuilder builder = component("Counter").in(INTEGER, "i").out(INTEGER, "o");
        ComponentBuilder.AutomatonBuilder automaton =
                builder.automaton(Completion.IGNORE, "only")
                        .variable(range(0, 3), "volume", "3")
                        .initial("only", "");
        Expression result =
                new Expression.Binary(
                        operator,
                        automaton.variable("volume"),
                        constant(INTEGER, operand),
                        INTEGER,
                        NOWHERE);
        return automaton
                .on("only", "i = ?", null, List.of(), List.of(automaton.assign("volume", result)))
                .build();
    }

    @Test
    void anAssignmentOutsideTheRangeIsAFault() {
        Component counter = calculating(Expression.BinaryOperator.PLUS, "1");
        assertThat(reactions(counter, "i", "0"))
                .containsExactly(
                        "error: Counter, only -> only (line 1): volume = 4 is outside"
                                + " Integer[0..3]");
    }

    @Test
    void aDivisionByZeroIsAFault() {
        Component counter = calculating(Expression.BinaryOperator.DIVIDE, "0");
        assertThat(reactions(counter, "i", "0"))
                .containsExactly("error: Counter, only -> only (line 1): division by zero");
    }

    @Test
    void cubesMeet() {
        Sent one = new Sent.Messages(List.of(new Value.IntegerValue(1)));
        assertThat(one.meet(new Sent.AnyMessage())).hasValue(one);
        assertThat(new Sent.AnyMessage().meet(one)).hasValue(one);
        assertThat(new Sent.Anything().meet(new Sent.AnyMessage())).hasValue(new Sent.AnyMessage());
        assertThat(Sent.SILENCE.meet(new Sent.AnyMessage())).isEmpty();
        assertThat(Sent.SILENCE.meet(one)).isEmpty();
        assertThat(Sent.SILENCE.meet(new Sent.Anything())).hasValue(Sent.SILENCE);
    }
}
