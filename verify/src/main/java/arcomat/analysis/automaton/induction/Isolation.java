package arcomat.analysis.automaton.induction;

import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.semantics.expression.Interval;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The terms that a condition compares a message with: where {@code 2 < p - v} is asked, {@code 2 +
 * v}. Sums and differences of whole numbers are brought to the other side, which is right where
 * they wrap around, too.
 */
public record Isolation(Port port) {

    /** In the order in which they are written. */
    public List<Expression> terms(Expression condition) {
        List<Expression> terms = new ArrayList<>();
        condition.visit(
                part -> {
                    if (part instanceof Expression.Binary binary && isComparison(binary)) {
                        isolated(binary.left(), binary.right()).ifPresent(terms::add);
                        isolated(binary.right(), binary.left()).ifPresent(terms::add);
                    } else if (part instanceof Expression.PortMatches matches
                            && matches.port().name().equals(port.name())) {
                        terms.addAll(matches.pattern().values());
                    }
                });
        return terms;
    }

    private static boolean isComparison(Expression.Binary binary) {
        return switch (binary.operator()) {
            case EQUAL, NOT_EQUAL, LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL -> true;
            default -> false;
        };
    }

    /** What the message is where one side is equal to the other. */
    private Optional<Expression> isolated(Expression side, Expression other) {
        if (!reads(side) || reads(other)) {
            return Optional.empty();
        }
        if (side.operands().isEmpty()) {
            return Optional.of(
                    other); // what reads the port, and is made of nothing, is the message
        }
        if (!Interval.isInteger(side.type())) {
            return Optional.empty();
        }
        if (side instanceof Expression.Cast cast && Interval.isInteger(cast.operand().type())) {
            return isolated(cast.operand(), narrowed(other, cast.operand().type()));
        }
        return side instanceof Expression.Binary binary
                ? isolated(binary, other)
                : Optional.empty();
    }

    private static Expression narrowed(Expression e, Type type) {
        Type whole =
                type instanceof Type.IntegerType integer
                        ? Type.IntegerType.of(integer.width())
                        : type;
        return e.type().equals(whole) ? e : new Expression.Cast(e, whole, e.span());
    }

    private Optional<Expression> isolated(Expression.Binary side, Expression other) {
        Expression left = side.left();
        Expression right = side.right();
        if (side.operator() == BinaryOperator.PLUS) {
            return reads(left)
                    ? isolated(left, calculated(BinaryOperator.MINUS, other, right, side))
                    : isolated(right, calculated(BinaryOperator.MINUS, other, left, side));
        }
        if (side.operator() == BinaryOperator.MINUS) {
            return reads(left)
                    ? isolated(left, calculated(BinaryOperator.PLUS, other, right, side))
                    : isolated(right, calculated(BinaryOperator.MINUS, left, other, side));
        }
        return Optional.empty();
    }

    private static Expression calculated(
            BinaryOperator operator, Expression left, Expression right, Expression like) {
        return new Expression.Binary(operator, left, right, like.type(), like.span());
    }

    private boolean reads(Expression e) {
        return e.ports().stream().anyMatch(each -> each.name().equals(port.name()));
    }
}
