package arcomat.analysis.bits;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.expression.Evaluation;
import arcomat.semantics.expression.Formulas;
import arcomat.semantics.expression.Scope;
import arcomat.semantics.expression.Term;

import java.util.List;
import java.util.Optional;

/**
 * Conditions about a number of floating point that is calculated from one message: rounding keeps
 * the order of numbers, and so do sums with constants, and products; so where such a number is less
 * than a constant, the message is up to another one. That is looked for by bisection, and computed
 * as a run does.
 */
public final class Thresholds {
    private static final Value[] NO_VARIABLES = {};

    private Thresholds() {}

    /** The same expression, in which a message is compared instead of what is calculated of it. */
    public static Expression simplified(Expression e) {
        return e.rewritten(
                each ->
                        each instanceof Expression.Binary binary && isOfReals(binary)
                                ? simplified(binary)
                                : each);
    }

    private static boolean isOfReals(Expression.Binary comparison) {
        return comparison.type() instanceof Type.BooleanType
                && comparison.left().type() instanceof Type.RealType
                && comparison.left().type().equals(comparison.right().type());
    }

    private static Expression simplified(Expression.Binary comparison) {
        return switch (comparison.operator()) {
            case EQUAL -> equal(comparison);
            case NOT_EQUAL -> Formulas.not(equal(comparison));
            default -> ordered(comparison).orElse(comparison);
        };
    }

    private static Expression equal(Expression.Binary comparison) {
        Optional<Expression> below = ordered(with(comparison, BinaryOperator.LESS_OR_EQUAL));
        Optional<Expression> above = ordered(with(comparison, BinaryOperator.GREATER_OR_EQUAL));
        return below.isPresent() && above.isPresent()
                ? Formulas.and(below.get(), above.get())
                : with(comparison, BinaryOperator.EQUAL);
    }

    private static Expression.Binary with(Expression.Binary e, BinaryOperator operator) {
        return new Expression.Binary(operator, e.left(), e.right(), e.type(), e.span());
    }

    private static Optional<Expression> ordered(Expression.Binary comparison) {
        boolean turned = isNumber(comparison.left());
        Expression calculated = turned ? comparison.right() : comparison.left();
        Expression constant = turned ? comparison.left() : comparison.right();
        return calculated instanceof Expression.PortRead || !isNumber(constant)
                ? Optional.empty()
                : calculated.match(new Order()).map(read -> threshold(comparison, read));
    }

    private static Optional<Double> number(Expression e) {
        return e instanceof Expression.Constant constant
                        && constant.value() instanceof Value.RealValue real
                        && !Double.isNaN(real.value())
                ? Optional.of(real.value())
                : Optional.empty();
    }

    private static boolean isNumber(Expression e) {
        return number(e).isPresent();
    }

    private static boolean isFinite(Expression e) {
        return number(e).filter(Double::isFinite).isPresent();
    }

    private static boolean isFactor(Expression e) {
        return isFinite(e) && number(e).filter(each -> each == 0).isEmpty();
    }

    private static boolean isReal(Expression e) {
        return e.type() instanceof Type.RealType;
    }

    private static Expression threshold(Expression.Binary comparison, Expression.PortRead message) {
        Port port = message.port();
        Term condition = Evaluation.compile(comparison, Scope.ofPorts(List.of(port)));
        Numbers numbers = Numbers.of(port.type());
        long low = numbers.least;
        long high = numbers.most;
        boolean isBelow = numbers.satisfies(condition, low);
        if (isBelow == numbers.satisfies(condition, high)) {
            return isBelow ? compared(message, BinaryOperator.EQUAL, message) : Formulas.FALSE;
        }
        while (low + 1 < high) {
            long middle = (low & high) + ((low ^ high) >> 1);
            if (numbers.satisfies(condition, middle) == isBelow) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Value last = numbers.value(isBelow ? low : high);
        return compared(
                message,
                isBelow ? BinaryOperator.LESS_OR_EQUAL : BinaryOperator.GREATER_OR_EQUAL,
                new Expression.Constant(last, port.type(), comparison.span()));
    }

    /** What is no number is not equal to itself. */
    private static Expression compared(
            Expression.PortRead message, BinaryOperator operator, Expression with) {
        return new Expression.Binary(
                operator, message, with, new Type.BooleanType(), message.span());
    }

    /**
     * The only message that a number is calculated from, in the same order or the opposite one.
     * Whatever is infinite on the way must not become what is no number.
     */
    private static final class Order
            implements Expression.SomeCases<Optional<Expression.PortRead>> {
        @Override
        public Optional<Expression.PortRead> otherwise(Expression other) {
            return Optional.empty();
        }

        @Override
        public Optional<Expression.PortRead> portRead(Expression.PortRead read) {
            return isReal(read) ? Optional.of(read) : Optional.empty();
        }

        @Override
        public Optional<Expression.PortRead> cast(Expression.Cast cast) {
            boolean isWhole = cast.operand().type() instanceof Type.IntegerType;
            return isWhole && cast.operand() instanceof Expression.PortRead read
                    ? Optional.of(read)
                    : of(cast.operand());
        }

        @Override
        public Optional<Expression.PortRead> unary(Expression.Unary negation) {
            return of(negation.operand());
        }

        private Optional<Expression.PortRead> of(Expression operand) {
            return isReal(operand) ? operand.match(this) : Optional.empty();
        }

        @Override
        public Optional<Expression.PortRead> binary(Expression.Binary binary) {
            return switch (binary.operator()) {
                case PLUS, MINUS ->
                        other(binary, isFinite(binary.left()), isFinite(binary.right()));
                case MULTIPLY -> other(binary, isFactor(binary.left()), isFactor(binary.right()));
                case DIVIDE -> other(binary, false, isFactor(binary.right()));
                default -> Optional.empty();
            };
        }

        /** Of two operands the one that is not constant. */
        private Optional<Expression.PortRead> other(
                Expression.Binary binary, boolean left, boolean right) {
            return left ? of(binary.right()) : right ? of(binary.left()) : Optional.empty();
        }
    }

    /** The numbers of a type in their order; there is one 0. */
    private record Numbers(Type type, long least, long most) {
        static Numbers of(Type type) {
            if (type instanceof Type.RealType real) {
                long infinity = RealFormat.of(real).infinity();
                return new Numbers(type, -infinity, infinity);
            }
            Type.IntegerType whole = (Type.IntegerType) type;
            return new Numbers(type, whole.low(), whole.high());
        }

        Value value(long number) {
            return type instanceof Type.RealType real
                    ? new Value.RealValue(RealFormat.of(real).atPlace(number))
                    : new Value.IntegerValue(number);
        }

        boolean satisfies(Term condition, long number) {
            return condition.isTrue(new Value[] {value(number)}, NO_VARIABLES);
        }
    }
}
