package arcomat.generate;

import arcomat.generate.language.Text;
import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/** Makes formulas of the two-valued conditions that {@code semantics.Guards} gives. */
final class Formulas {
    private final ExpressionText text;
    private final Simplification simplification;

    Formulas(ExpressionText text) {
        this.text = text;
        this.simplification = new Simplification(text::mayBeAbsent);
    }

    Formula of(Expression e) {
        if (e instanceof Expression.Constant constant
                && constant.value() instanceof Value.BooleanValue truth) {
            return new Formula.Truth(truth.value());
        }
        if (e instanceof Expression.PortMatches matches) {
            return matches(matches.port(), matches);
        }
        if (e instanceof Expression.Unary unary && unary.operator() == UnaryOperator.NOT) {
            return simplification.not(of(unary.operand()));
        }
        if (e instanceof Expression.Binary binary) {
            return binary(binary);
        }
        if (e instanceof Expression.PortRead read) {
            return is(read, true, truth(true, e));
        }
        return Formula.Test.of(text.of(e), mayFail(e));
    }

    private Formula matches(Port port, Expression.PortMatches matches) {
        if (!(matches.pattern() instanceof Automaton.OneOf oneOf)) {
            boolean something = matches.pattern() instanceof Automaton.Present;
            return simplification.and(List.of(new Formula.Carries(port, something)));
        }
        Expression.PortRead read = new Expression.PortRead(port, matches.span());
        List<Formula> values = new ArrayList<>();
        oneOf.values().forEach(v -> values.add(is(read, true, v)));
        return simplification.and(
                List.of(new Formula.Carries(port, true), simplification.or(values)));
    }

    private Formula binary(Expression.Binary binary) {
        BinaryOperator operator = binary.operator();
        if (operator == BinaryOperator.AND) {
            return simplification.and(row(binary, operator));
        }
        if (operator == BinaryOperator.OR) {
            return simplification.or(row(binary, operator));
        }
        boolean equality = operator == BinaryOperator.EQUAL || operator == BinaryOperator.NOT_EQUAL;
        if (equality && binary.left() instanceof Expression.PortRead read) {
            return is(read, operator == BinaryOperator.EQUAL, binary.right());
        }
        return test(binary);
    }

    private boolean mayFail(Expression e) {
        return text.mayFail(e, e.type());
    }

    /**
     * Of whole numbers one is less than the other one, or it is not; what is no number is neither.
     */
    private Formula test(Expression.Binary binary) {
        Text whole = text.of(binary);
        if (!(binary.left().type() instanceof Type.IntegerType)) {
            return Formula.Test.of(whole, mayFail(binary));
        }
        String left = text.of(binary.left()).text();
        String right = text.of(binary.right()).text();
        Optional<Formula.Bounds> bounds = bounds(binary);
        boolean fails = mayFail(binary);
        return switch (binary.operator()) {
            case LESS -> new Formula.Test(whole, left + " < " + right, true, fails, bounds);
            case GREATER_OR_EQUAL ->
                    new Formula.Test(whole, left + " < " + right, false, fails, bounds);
            case GREATER -> new Formula.Test(whole, right + " < " + left, true, fails, bounds);
            case LESS_OR_EQUAL ->
                    new Formula.Test(whole, right + " < " + left, false, fails, bounds);
            case EQUAL -> new Formula.Test(whole, left + " == " + right, true, fails, bounds);
            case NOT_EQUAL -> new Formula.Test(whole, left + " == " + right, false, fails, bounds);
            case MULTIPLY, DIVIDE, REMAINDER, PLUS, MINUS, AND, OR, IMPLIES, EQUIVALENT ->
                    Formula.Test.of(whole, fails);
        };
    }

    /** The operands of a row of {@code &&} or {@code ||}, all at once: it may be long. */
    private List<Formula> row(Expression row, BinaryOperator operator) {
        List<Formula> operands = new ArrayList<>();
        Deque<Expression> open = new ArrayDeque<>(List.of(row));
        while (!open.isEmpty()) {
            Expression next = open.pop();
            if (next instanceof Expression.Binary binary && binary.operator() == operator) {
                open.push(binary.right());
                open.push(binary.left());
            } else {
                operands.add(of(next));
            }
        }
        return operands;
    }

    private Formula is(Expression.PortRead read, boolean equal, Expression value) {
        Optional<Value> constant =
                value instanceof Expression.Constant c ? Optional.of(c.value()) : Optional.empty();
        if (constant.isPresent() && constant.get() instanceof Value.BooleanValue truth) {
            boolean wanted = truth.value() == equal;
            Text asked = text.of(read);
            Text negated =
                    text.of(
                            new Expression.Unary(
                                    UnaryOperator.NOT, read, read.type(), read.span()));
            return new Formula.Is(
                    read.port(),
                    true,
                    Optional.of(new Value.BooleanValue(wanted)),
                    wanted ? asked : negated,
                    wanted ? negated : asked);
        }
        Text same = text.equal(read, value);
        Text other = text.notEqual(read, value);
        if (readsPort(value)) {
            // Two silent ports have equal codes: this does not say that there is a message.
            return Formula.Test.of(equal ? same : other, mayFail(value));
        }
        return new Formula.Is(
                read.port(), equal, constant, equal ? same : other, equal ? other : same);
    }

    private static boolean readsPort(Expression value) {
        return value.contains(Expression.PortRead.class::isInstance);
    }

    private static Expression truth(boolean value, Expression because) {
        return new Expression.Constant(
                new Value.BooleanValue(value), new Type.BooleanType(), because.span());
    }

    /** What a comparison of a number with a constant says. */
    private Optional<Formula.Bounds> bounds(Expression.Binary binary) {
        boolean number =
                binary.left() instanceof Expression.VariableRead
                        || binary.left() instanceof Expression.PortRead;
        if (!number
                || !(binary.right() instanceof Expression.Constant constant)
                || !(constant.value() instanceof Value.IntegerValue integer)) {
            return Optional.empty();
        }
        String name = text.of(binary.left()).text();
        long value = integer.value();
        return switch (binary.operator()) {
            case EQUAL -> Optional.of(new Formula.Bounds(name, value, value));
            case LESS_OR_EQUAL -> Optional.of(new Formula.Bounds(name, Long.MIN_VALUE, value));
            case GREATER_OR_EQUAL -> Optional.of(new Formula.Bounds(name, value, Long.MAX_VALUE));
            case LESS ->
                    value == Long.MIN_VALUE
                            ? Optional.empty()
                            : Optional.of(new Formula.Bounds(name, Long.MIN_VALUE, value - 1));
            case GREATER ->
                    value == Long.MAX_VALUE
                            ? Optional.empty()
                            : Optional.of(new Formula.Bounds(name, value + 1, Long.MAX_VALUE));
            case MULTIPLY,
                    DIVIDE,
                    REMAINDER,
                    PLUS,
                    MINUS,
                    NOT_EQUAL,
                    AND,
                    OR,
                    IMPLIES,
                    EQUIVALENT ->
                    Optional.empty();
        };
    }
}
