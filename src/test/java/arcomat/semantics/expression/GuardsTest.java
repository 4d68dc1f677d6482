package arcomat.semantics.expression;

import static arcomat.semantics.ComponentBuilder.NOWHERE;
import static arcomat.semantics.Expressions.binary;
import static arcomat.semantics.Expressions.not;
import static arcomat.semantics.Expressions.number;
import static arcomat.semantics.Expressions.read;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.model.Automaton;
import arcomat.model.Component.Profile;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Value;
import arcomat.semantics.ExpressionText;
import arcomat.semantics.Expressions;
import arcomat.semantics.StaleReading;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.function.Supplier;

class GuardsTest {
    private static final Value TRUE = new Value.BooleanValue(true);
    private static final Value FALSE = new Value.BooleanValue(false);
    private static final Guards GUARDS = new Guards(Profile.TIME_SYNCHRONOUS);

    /** Takes every guard for one that nests deeply. */
    private static final Guards DEEP = new Guards(Profile.TIME_SYNCHRONOUS, 0, false);

    @Provide
    Arbitrary<Expression> guards() {
        return Expressions.guards();
    }

    /** Guards that may go wrong. */
    @Provide
    Arbitrary<Expression> nests() {
        Arbitrary<Expression> wide = Expressions.guards().map(e -> e.rewritten(this::dividing));
        return Arbitraries.frequencyOf(Tuple.of(1, wide), Tuple.of(2, nests(3)));
    }

    private Arbitrary<Expression> nests(int depth) {
        Expression some = binary(BinaryOperator.LESS, number("1"), dividing(read("m")));
        Expression any = binary(BinaryOperator.LESS, number("1"), dividing(read("n")));
        Expression silent = Expressions.matches("p", new Automaton.Absent());
        Arbitrary<Expression> leaves = Arbitraries.of(read("p"), read("q"), some, any, silent);
        if (depth == 0) {
            return leaves;
        }
        Arbitrary<Expression> inner = nests(depth - 1);
        return Arbitraries.oneOf(
                leaves,
                inner.map(Expressions::not),
                Combinators.combine(Expressions.connectives(), inner, inner)
                        .as(Expressions::binary),
                Combinators.combine(inner, inner, inner).as(Expressions::choice));
    }

    /** Numbers that come by ports divide another one. */
    private Expression dividing(Expression e) {
        return e instanceof Expression.PortRead read && read.type().isNumber()
                ? new Expression.Binary(
                        BinaryOperator.DIVIDE, number("2"), read, read.type(), NOWHERE)
                : e;
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

    private static Value evaluate(Expression expression, Value[] letter) {
        Scope scope = new Scope(Expressions.COMPONENT, List.of());
        return Evaluation.compile(expression, scope).evaluate(letter, new Value[0]);
    }

    @Property(seed = "1", tries = 2000, edgeCases = EdgeCasesMode.NONE)
    void twoValuesSayWhenKleenesGuardIsTrue(
            @ForAll("guards") Expression guard, @ForAll("letters") Value[] letter) {
        Value kleene = evaluate(guard, letter);
        for (Guards guards : List.of(GUARDS, DEEP)) {
            assertThat(evaluate(Expressions.trueWhen(guards, guard), letter))
                    .isEqualTo(truth(kleene));
            assertThat(evaluate(Expressions.trueWhen(guards, not(guard)), letter))
                    .isEqualTo(truth(FALSE.equals(kleene) ? TRUE : FALSE));
        }
    }

    /** The one with the greater rank is enabled where its guard is true and the other's is not. */
    @Property(seed = "3", tries = 1000, edgeCases = EdgeCasesMode.NONE)
    void whoComesFirstIsNotAskedInVain(
            @ForAll("guards") Expression first,
            @ForAll("guards") Expression second,
            @ForAll("letters") Value[] letter) {
        Automaton automaton =
                new Automaton(
                        "",
                        Automaton.Completion.IGNORE,
                        Automaton.Omitted.SILENT,
                        List.of("here"),
                        List.of(),
                        List.of(),
                        List.of(Expressions.ranked(second, 1), Expressions.ranked(first, 0)),
                        NOWHERE);
        boolean expected =
                TRUE.equals(evaluate(second, letter)) && !TRUE.equals(evaluate(first, letter));
        Expression enabled = GUARDS.enabledWhen(automaton, automaton.transitions().get(0));
        assertThat(evaluate(enabled, letter)).isEqualTo(new Value.BooleanValue(expected));
        for (boolean stale : new boolean[] {false, true}) {
            assertThat(new StaleReading(letter, stale).holds(enabled)).isEqualTo(expected);
        }
        Expression before = GUARDS.enabledWhen(automaton, automaton.transitions().get(1));
        assertThat(evaluate(before, letter)).isEqualTo(truth(evaluate(first, letter)));
    }

    private static Value truth(Value value) {
        return TRUE.equals(value) ? TRUE : FALSE;
    }

    /** Generated code may hold anything in the field of an absent port. */
    @Property(seed = "2", tries = 2000, edgeCases = EdgeCasesMode.NONE)
    void whatAnAbsentPortLastCarriedHasNoInfluence(
            @ForAll("guards") Expression guard, @ForAll("letters") Value[] letter) {
        for (Guards guards : List.of(GUARDS, DEEP)) {
            Expression condition = Expressions.trueWhen(guards, guard);
            Value strict = evaluate(condition, letter);
            for (boolean stale : new boolean[] {false, true}) {
                assertThat(new StaleReading(letter, stale).holds(condition))
                        .isEqualTo(TRUE.equals(strict));
            }
        }
    }

    /** Where it goes wrong, both do, also where a port still holds an old message. */
    @Property(seed = "4", tries = 3000, edgeCases = EdgeCasesMode.NONE)
    void whatIsJudgedOrAskedOnceIsWhatIsAsked(
            @ForAll("nests") Expression guard, @ForAll("letters") Value[] letter) {
        for (Expression each : List.of(guard, not(guard))) {
            Object asked = outcome(() -> evaluate(GUARDS.isTrue(each), letter));
            for (Expression same : List.of(GUARDS.judged(each), DEEP.isTrue(each))) {
                assertThat(outcome(() -> evaluate(same, letter))).isEqualTo(asked);
                for (boolean stale : new boolean[] {false, true}) {
                    StaleReading reading = new StaleReading(letter, stale);
                    assertThat(outcome(() -> new Value.BooleanValue(reading.holds(same))))
                            .isEqualTo(asked);
                }
            }
        }
    }

    private static Object outcome(Supplier<Value> evaluation) {
        try {
            return evaluation.get();
        } catch (Fault wrong) {
            return "wrong";
        }
    }

    private static String text(Expression e) {
        return ExpressionText.of(e);
    }

    private static Expression and(Expression left, Expression right) {
        return binary(BinaryOperator.AND, left, right);
    }

    @Test
    void conditionsReadAsAPersonWouldWriteThem() {
        Expression greater = binary(BinaryOperator.LESS, number("1"), read("m"));
        assertThat(text(Expressions.trueWhen(GUARDS, greater))).isEqualTo("(m? && (1 LESS m))");
        Expression both = and(greater, binary(BinaryOperator.LESS, read("m"), number("5")));
        assertThat(text(Expressions.trueWhen(GUARDS, both)))
                .isEqualTo("((m? && (1 LESS m)) && (m LESS 5))");
        assertThat(text(Expressions.trueWhen(GUARDS, not(and(read("p"), read("q"))))))
                .isEqualTo("((p? && !p) || (q? && !q))");
    }

    @Test
    void totalPortsNeedNoTest() {
        Expression small = binary(BinaryOperator.LESS, read("n"), number("5"));
        assertThat(text(Expressions.trueWhen(GUARDS, small))).isEqualTo("(n LESS 5)");
        Guards events = new Guards(Profile.EVENT_DRIVEN);
        assertThat(text(Expressions.trueWhen(events, small))).isEqualTo("(n? && (n LESS 5))");
    }

    @Test
    void absenceIsDecidedWithoutAMessage() {
        Expression absent = Expressions.matches("p", new Automaton.Absent());
        assertThat(text(Expressions.trueWhen(GUARDS, absent))).isEqualTo("p--");
        assertThat(text(Expressions.trueWhen(GUARDS, not(absent)))).isEqualTo("p?");
        assertThat(
                        text(
                                Expressions.trueWhen(
                                        GUARDS, Expressions.matches("n", new Automaton.Absent()))))
                .isEqualTo("false");
    }

    @Test
    void longEquivalencesStaySmall() {
        Expression chain = read("p");
        for (int i = 0; i < 40; i++) {
            chain = binary(BinaryOperator.EQUIVALENT, chain, and(read("p"), read("q")));
        }
        int[] size = {0};
        Expressions.trueWhen(GUARDS, chain).visit(e -> size[0]++);
        assertThat(size[0]).isLessThan(5000);
    }
}
