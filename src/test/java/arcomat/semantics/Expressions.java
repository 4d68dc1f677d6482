package arcomat.semantics;

import static arcomat.semantics.ComponentBuilder.BOOLEAN;
import static arcomat.semantics.ComponentBuilder.INTEGER;
import static arcomat.semantics.ComponentBuilder.NOWHERE;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.semantics.expression.Guards;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;

import java.util.List;
import java.util.Optional;

/** Arbitrary expressions over a component with two Boolean ports and two numbers, one total. */
public final class Expressions {
    private static final ComponentBuilder PORTS =
            ComponentBuilder.component("C")
                    .in(BOOLEAN, "p")
                    .in(BOOLEAN, "q")
                    .in(INTEGER, "m")
                    .totalIn(INTEGER, "n");
    public static final Component COMPONENT = PORTS.build();

    private Expressions() {}

    public static Arbitrary<Expression> guards() {
        return guards(4);
    }

    private static Arbitrary<Expression> guards(int depth) {
        Arbitrary<Expression> atoms =
                Arbitraries.of(
                        PORTS.read("p"),
                        PORTS.read("q"),
                        ComponentBuilder.constant(BOOLEAN, "true"),
                        ComponentBuilder.constant(BOOLEAN, "false"),
                        matches("p", new Automaton.Absent()),
                        matches("m", new Automaton.Present()),
                        matches("n", new Automaton.Absent()),
                        matches("p", new Automaton.OneOf(List.of(PORTS.read("q")))),
                        matches("m", new Automaton.OneOf(List.of(PORTS.read("n"), number("1")))));
        if (depth == 0) {
            return atoms;
        }
        Arbitrary<Expression> inner = guards(depth - 1);
        Arbitrary<Expression> numbers = numbers(depth - 1);
        return Arbitraries.oneOf(
                atoms,
                inner.map(Expressions::not),
                Combinators.combine(connectives(), inner, inner).as(Expressions::binary),
                Combinators.combine(comparisons(), numbers, numbers).as(Expressions::binary),
                Combinators.combine(inner, inner, inner).as(Expressions::choice),
                Combinators.combine(numbers, numbers, numbers)
                        .as((e, a, b) -> new Expression.IsIn(e, List.of(a, b), NOWHERE)));
    }

    private static Arbitrary<Expression> numbers(int depth) {
        Arbitrary<Expression> atoms =
                Arbitraries.of(PORTS.read("m"), PORTS.read("n"), number("0"), number("1"));
        if (depth <= 1) {
            return atoms;
        }
        Arbitrary<Expression> inner = numbers(depth - 1);
        return Arbitraries.oneOf(
                atoms,
                Combinators.combine(inner, inner)
                        .as(
                                (a, b) ->
                                        new Expression.Binary(
                                                BinaryOperator.PLUS, a, b, INTEGER, NOWHERE)),
                Combinators.combine(guards(depth - 1), inner, inner)
                        .as((c, a, b) -> new Expression.Conditional(c, a, b, INTEGER, NOWHERE)));
    }

    public static Arbitrary<BinaryOperator> connectives() {
        return Arbitraries.of(
                BinaryOperator.AND,
                BinaryOperator.OR,
                BinaryOperator.IMPLIES,
                BinaryOperator.EQUIVALENT,
                BinaryOperator.EQUAL,
                BinaryOperator.NOT_EQUAL);
    }

    private static Arbitrary<BinaryOperator> comparisons() {
        return Arbitraries.of(
                BinaryOperator.LESS, BinaryOperator.EQUAL, BinaryOperator.GREATER_OR_EQUAL);
    }

    public static Expression binary(BinaryOperator operator, Expression left, Expression right) {
        return new Expression.Binary(operator, left, right, BOOLEAN, NOWHERE);
    }

    public static Expression choice(Expression condition, Expression then, Expression otherwise) {
        return new Expression.Conditional(condition, then, otherwise, BOOLEAN, NOWHERE);
    }

    /** When a guard is true; false where it is false or undefined. */
    public static Expression trueWhen(Guards guards, Expression guard) {
        return guards.asked(
                new Automaton.Transition(
                        0, 0, Optional.of(guard), List.of(), List.of(), List.of(), NOWHERE));
    }

    /** A transition that asks a guard alone. */
    public static Automaton.Transition ranked(Expression guard, int rank) {
        return new Automaton.Transition(
                0, 0, Optional.of(guard), List.of(), List.of(), List.of(), rank, NOWHERE);
    }

    public static Expression not(Expression e) {
        return new Expression.Unary(Expression.UnaryOperator.NOT, e, BOOLEAN, NOWHERE);
    }

    public static Expression number(String text) {
        return ComponentBuilder.constant(INTEGER, text);
    }

    public static Expression matches(String port, Automaton.Pattern pattern) {
        Port asked = PORTS.port(port);
        return new Expression.PortMatches(asked, pattern, NOWHERE);
    }

    public static Expression read(String port) {
        return PORTS.read(port);
    }
}
