package arcomat.semantics.automaton;

import static arcomat.semantics.ComponentBuilder.NOWHERE;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Completion;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Refusal;
import arcomat.model.Refusal.Truth;
import arcomat.model.Value;
import arcomat.models.ReadModels;
import arcomat.semantics.Expressions;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Scope;
import arcomat.source.SourceFile;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;

import org.junit.jupiter.api.Test;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

class WhyNotTest {
    private static final Configuration START = new Configuration(0);

    @Provide
    Arbitrary<List<Expression>> conjuncts() {
        return Expressions.guards().list().ofMinSize(1).ofMaxSize(3);
    }

    @Provide
    Arbitrary<Value[]> letters() {
        Arbitrary<Value> flags =
                Arbitraries.of(true, false).<Value>map(Value.BooleanValue::new).injectNull(0.4);
        Arbitrary<Value> numbers =
                Arbitraries.integers().between(0, 2).<Value>map(n -> new Value.IntegerValue(n));
        return Combinators.combine(flags, flags, numbers.injectNull(0.4), numbers)
                .as((p, q, m, n) -> new Value[] {p, q, m, n});
    }

    /** A part of a guard is true, false or undefined as Kleene's logic has it. */
    @Tag("slow")
    @Property(seed = "1", tries = 3000, edgeCases = EdgeCasesMode.NONE)
    void clausesAreJudgedAsKleeneDoes(
            @ForAll("conjuncts") List<Expression> conjuncts, @ForAll("letters") Value[] letter) {
        Expression guard = conjuncts.stream().reduce(WhyNotTest::and).orElseThrow();
        StepRelation relation = relation(guard);
        Input input = Input.of(letter);
        List<Refusal> refusals = WhyNot.of(relation).refusals(START, input);
        assertThat(refusals.isEmpty()).isEqualTo(!relation.enabled(START, input).isEmpty());
        for (Refusal refusal : refusals) {
            List<Truth> expected = conjuncts(guard).map(each -> truth(each, letter)).toList();
            assertThat(refusal.clauses()).extracting(Refusal.Clause::truth).isEqualTo(expected);
            assertThat(refusal.failed())
                    .isNotEmpty()
                    .allSatisfy(each -> assertThat(each.because()).isNotEmpty());
        }
    }

    private static Expression and(Expression left, Expression right) {
        return Expressions.binary(BinaryOperator.AND, left, right);
    }

    private static Stream<Expression> conjuncts(Expression guard) {
        return guard instanceof Expression.Binary both && both.operator() == BinaryOperator.AND
                ? guard.operands().stream().flatMap(WhyNotTest::conjuncts)
                : Stream.of(guard);
    }

    private static Truth truth(Expression expression, Value[] letter) {
        Scope scope = new Scope(Expressions.COMPONENT, List.of());
        Value value = Evaluation.compile(expression, scope).evaluate(letter, new Value[0]);
        if (value == null) {
            return Truth.UNDEFINED;
        }
        return value.equals(new Value.BooleanValue(true)) ? Truth.TRUE : Truth.FALSE;
    }

    private static StepRelation relation(Expression guard) {
        Automaton.Transition transition =
                new Automaton.Transition(
                        0, 0, Optional.of(guard), List.of(), List.of(), List.of(), NOWHERE);
        Automaton automaton =
                new Automaton(
                        "",
                        Completion.IGNORE,
                        Automaton.Omitted.SILENT,
                        List.of("s"),
                        List.of(),
                        List.of(new Automaton.Initial(0, List.of(), List.of(), NOWHERE)),
                        List.of(transition),
                        NOWHERE);
        return ComponentSemantics.of(Expressions.COMPONENT, List.of(automaton), List.of())
                .relations()
                .get(0);
    }

    private static String nearest(String ports, String transitions, Map<String, Value> messages) {
        String text =
                """
                component C(Integer[0..9] limit = 5) {
                  %s
                  <<completion = "ignore">> automaton {
                    state s, t;
                    variable Integer[0..9] n = 7;
                    initial s;
                    %s
                  }
                }
                """
                        .formatted(ports, transitions);
        Component component =
                ReadModels.model(List.of(new SourceFile("C.arc", text)))
                        .component("C")
                        .orElseThrow();
        List<Value> arguments = component.parameters().isEmpty() ? List.of() : List.of(number(5));
        StepRelation relation = ComponentSemantics.of(component, arguments).relations().get(0);
        Map<String, Value> letter = new LinkedHashMap<>();
        for (Port port : component.inputs()) {
            Optional.ofNullable(messages.get(port.name()))
                    .ifPresent(value -> letter.put(port.name(), value));
        }
        return WhyNot.of(relation)
                .nearest(
                        relation.starts().get(0).configuration(),
                        Input.of(component, Letter.of(letter)))
                .map(Refusal::words)
                .orElse("");
    }

    private static Value number(int number) {
        return new Value.IntegerValue(number);
    }

    private static final String PORTS =
            "port in Boolean blocked, in Integer[0..99] distance, out Integer[0..99] seen;";

    @Test
    void aSilentPortIsNamed() {
        assertThat(nearest(PORTS, "s -> t [!blocked];", Map.of()))
                .isEqualTo("s -> t (line 7) did not fire: !blocked: blocked is silent");
    }

    @Test
    void valuesAreShownWhereAClauseIsFalse() {
        Map<String, Value> letter = Map.of("distance", number(25));
        assertThat(nearest(PORTS, "s -> t [distance < 20 && n < limit];", letter))
                .isEqualTo(
                        "s -> t (line 7) did not fire: distance < 20: distance is 25;"
                                + " n < limit: n is 7, limit is 5");
        assertThat(nearest(PORTS, "s -> t {distance == --};", letter))
                .isEqualTo("s -> t (line 7) did not fire: distance == --: distance is 25");
        assertThat(nearest(PORTS, "s -> t [1 > 2];", letter))
                .isEqualTo("s -> t (line 7) did not fire: 1 > 2: it is never true");
    }

    @Test
    void whatIsSentHasToBeThere() {
        assertThat(nearest(PORTS, "s -> t / {seen = distance};", Map.of()))
                .isEqualTo("s -> t (line 7) did not fire: / {seen = distance}: distance is silent");
        assertThat(nearest(PORTS, "s -> t [distance > 3] / {seen = distance};", Map.of()))
                .isEqualTo("s -> t (line 7) did not fire: distance > 3: distance is silent");
    }

    @Test
    void aDivisionThatGoesWrongIsSaidWhereTheGuardDoesNotReachIt() {
        assertThat(
                        nearest(
                                PORTS,
                                "s -> t [distance != 0 && 9 / distance > 1];",
                                Map.of("distance", number(0))))
                .isEqualTo(
                        "s -> t (line 7) did not fire: distance != 0: distance is 0;"
                                + " 9 / distance > 1: division by zero");
    }

    @Test
    void theNearestLacksLeastAndComesFirst() {
        String transitions =
                """
                s -> t [n > 8 && n > 7 && distance > 20];
                    s -> t [distance > 30 && distance > 40] {blocked == true};
                    s -> s {distance == ?} / {seen = distance};
                    s -> t {blocked == true};
                """;
        assertThat(nearest(PORTS, transitions, Map.of()))
                .isEqualTo("s -> s (line 9) did not fire: distance == ?: distance is silent");
    }

    @Test
    void noTransitionIsNoneThatIsNear() {
        assertThat(nearest(PORTS, "t -> s;", Map.of())).isEmpty();
    }
}
