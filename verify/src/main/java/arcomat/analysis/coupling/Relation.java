package arcomat.analysis.coupling;

import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Type;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * How two things are compared. Of numbers of floating point, {@code a == b} is not that both are
 * the same message, since there are two zeros, and what is no number is not equal to itself; and
 * {@code a < b} is not the opposite of {@code b <= a}.
 */
enum Relation {
    /** Both are the same message. */
    IS("is", Optional.empty(), Things.REALS),
    EQUAL(BinaryOperator.EQUAL, Things.ALL),
    NOT_EQUAL(BinaryOperator.NOT_EQUAL, Things.ALL),
    LESS(BinaryOperator.LESS, Things.NUMBERS),
    LESS_OR_EQUAL(BinaryOperator.LESS_OR_EQUAL, Things.NUMBERS),
    GREATER(BinaryOperator.GREATER, Things.NUMBERS),
    GREATER_OR_EQUAL(BinaryOperator.GREATER_OR_EQUAL, Things.NUMBERS),
    NOT_LESS(LESS),
    NOT_LESS_OR_EQUAL(LESS_OR_EQUAL),
    NOT_GREATER(GREATER),
    NOT_GREATER_OR_EQUAL(GREATER_OR_EQUAL);

    private static final String DENIED = "!(";

    /** What can be compared. */
    private enum Things {
        ALL,
        NUMBERS,
        REALS
    }

    private final String sign;
    private final Optional<BinaryOperator> operator;
    private final Things things;
    private final boolean denied;

    Relation(BinaryOperator operator, Things things) {
        this(operator.sign(), Optional.of(operator), things);
    }

    Relation(String sign, Optional<BinaryOperator> operator, Things things) {
        this.sign = sign;
        this.operator = operator;
        this.things = things;
        this.denied = false;
    }

    /** The opposite, which is another order of whole numbers. */
    Relation(Relation other) {
        this.sign = other.sign;
        this.operator = other.operator;
        this.things = Things.REALS;
        this.denied = true;
    }

    private static boolean isReal(Type type) {
        return type instanceof Type.RealType;
    }

    private boolean fits(Type type) {
        return switch (things) {
            case ALL -> true;
            case NUMBERS -> isReal(type) || type instanceof Type.IntegerType;
            case REALS -> isReal(type);
        };
    }

    /** Whether two things of a type are the same message. */
    static Relation same(Type type) {
        return isReal(type) ? IS : EQUAL;
    }

    /** Those by which the size of numbers of a type is told; of two opposite ones, one holds. */
    static List<Relation> orders(Type type) {
        return isReal(type)
                ? List.of(
                        LESS,
                        GREATER,
                        LESS_OR_EQUAL,
                        GREATER_OR_EQUAL,
                        NOT_LESS,
                        NOT_GREATER,
                        NOT_LESS_OR_EQUAL,
                        NOT_GREATER_OR_EQUAL)
                : List.of(LESS_OR_EQUAL, GREATER_OR_EQUAL);
    }

    /** The operator of models; none where they have no such one. */
    Optional<BinaryOperator> operator() {
        return operator;
    }

    /** Whether it is that the operator does not hold. */
    boolean isDenied() {
        return denied;
    }

    String text(String one, String other) {
        String plain = one + " " + sign + " " + other;
        return denied ? DENIED + plain + ")" : plain;
    }

    /** Whether a text says that something is not so. */
    static boolean isDenied(String text) {
        return text.startsWith(DENIED) && text.endsWith(")");
    }

    /** What is not so, of such a text. */
    static String undenied(String text) {
        return text.substring(DENIED.length(), text.length() - 1);
    }

    /** The one for things of a type. */
    static Optional<Relation> of(String sign, boolean denied, Type type) {
        return Arrays.stream(values())
                .filter(each -> each.sign.equals(sign))
                .filter(each -> each.denied == denied)
                .filter(each -> each.fits(type))
                .findFirst();
    }
}
