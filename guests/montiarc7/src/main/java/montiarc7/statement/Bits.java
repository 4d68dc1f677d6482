package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BitExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ShiftExpressionContext;
import montiarc7.statement.Kinds.Kind;

import java.util.Map;
import java.util.Optional;

/**
 * What Java does with bits, where arithmetic says exactly the same: Arcomat calculates with numbers
 * of 32 and 64 bits that wrap around, and knows no bits.
 */
final class Bits {
    /** Of single bits, and of truth values. */
    private static final Map<String, String> TRUTHS = Map.of("&", "&&", "|", "||", "^", "!=");

    private final Scope scope;
    private final ExpressionWriter writer;
    private final Kinds kinds;

    Bits(Scope scope, ExpressionWriter writer) {
        this.scope = scope;
        this.writer = writer;
        this.kinds = new Kinds(scope);
    }

    /** Nothing where no arithmetic says it, or where it is about something else. */
    Optional<String> write(ExpressionContext expression) {
        if (expression instanceof BitExpressionContext bits) {
            return kinds.of(bits) == Kind.TRUTH ? Optional.of(truth(bits)) : masked(bits);
        } else if (expression instanceof ShiftExpressionContext shift) {
            return shifted(shift);
        } else if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("~")
                && kinds.of(prefix).isWhole()) {
            return Optional.of("(-1 - " + text(prefix.expression()) + ")");
        } else if (expression instanceof BinaryExpressionContext binary) {
            return compared(binary);
        }
        return Optional.empty();
    }

    private String truth(BitExpressionContext bits) {
        String operator = TRUTHS.get(bits.op.getText());
        return "(%s %s %s)".formatted(text(bits.expression(0)), operator, text(bits.expression(1)));
    }

    /** The lowest bits of a number: what is left of it when a power of two divides it. */
    private Optional<String> masked(BitExpressionContext bits) {
        Kind kind = kinds.of(bits);
        Optional<Number> mask = constant(bits.expression(1));
        if (!bits.op.getText().equals("&") || !kind.isWhole() || mask.isEmpty()) {
            return Optional.empty();
        }
        long divisor = mask.get().longValue() + 1;
        boolean isPower = divisor > 1 && Long.bitCount(divisor) == 1;
        if (!isPower || divisor > 1L << kind.bits() - 2) {
            return Optional.empty();
        }
        String power = literal(divisor, kind);
        String value = text(bits.expression(0));
        return Optional.of("((%s %% %s + %s) %% %s)".formatted(value, power, power, power));
    }

    private Optional<String> shifted(ShiftExpressionContext shift) {
        Kind kind = kinds.of(shift);
        Optional<Integer> distance = distance(shift);
        if (distance.isEmpty()) {
            return Optional.empty();
        }
        String power = literal(1L << distance.get(), kind);
        String value = text(shift.expression(0));
        String other = "(-1 - " + value + ") / " + power;
        return switch (shift.shift().getText()) {
            case "<<" -> Optional.of("(%s * %s)".formatted(value, power));
            case ">>" -> Optional.of(choice(value, power, "-1", other));
            default ->
                    distance.get() == 0
                            ? Optional.of(value)
                            : Optional.of(
                                    choice(
                                            value,
                                            power,
                                            literal(
                                                    -1L >>> 64 - kind.bits() + distance.get(),
                                                    kind),
                                            other));
        };
    }

    private static String choice(String value, String power, String from, String other) {
        return "(%s >= 0 ? %s / %s : %s - %s)".formatted(value, value, power, from, other);
    }

    /** By how many bits, where these are less than those of which the sign is one. */
    private Optional<Integer> distance(ShiftExpressionContext shift) {
        Kind kind = kinds.of(shift);
        return constant(shift.expression(1))
                .filter(each -> kind.isWhole())
                .map(Number::longValue)
                .filter(each -> each >= 0 && each <= kind.bits() - 2)
                .map(Long::intValue);
    }

    /** With zero, which asks whether any bit is set, or the one that is the sign. */
    private Optional<String> compared(BinaryExpressionContext binary) {
        boolean isLeft = isZero(binary.expression(0));
        ExpressionContext asked = bare(binary.expression(isLeft ? 1 : 0));
        if (!isLeft && !isZero(binary.expression(1))
                || !isOfBits(asked)
                || !kinds.of(asked).isWhole()) {
            return Optional.empty();
        }
        return switch (binary.op.getText()) {
            case "==" -> Optional.of("(" + nothing(asked, 0) + ")");
            case "!=" -> Optional.of("!(" + nothing(asked, 0) + ")");
            case "<" -> Optional.of(negative(asked)).filter(each -> !isLeft);
            case ">=" -> Optional.of("!" + negative(asked)).filter(each -> !isLeft);
            case ">" -> Optional.of(negative(asked)).filter(each -> isLeft);
            case "<=" -> Optional.of("!" + negative(asked)).filter(each -> isLeft);
            default -> Optional.empty();
        };
    }

    private boolean isZero(ExpressionContext expression) {
        return constant(expression).filter(each -> each.longValue() == 0).isPresent();
    }

    /** Whether the bit is set that is the sign. */
    private String negative(ExpressionContext at) {
        ExpressionContext expression = bare(at);
        if (expression instanceof BitExpressionContext bits) {
            String operator = TRUTHS.get(bits.op.getText());
            return "(%s %s %s)"
                    .formatted(
                            negative(bits.expression(0)), operator, negative(bits.expression(1)));
        }
        return "(" + text(expression) + " < 0)";
    }

    private static boolean isOfBits(ExpressionContext expression) {
        return expression instanceof BitExpressionContext
                || expression instanceof ShiftExpressionContext;
    }

    /**
     * Whether no bit of a number is set, behind its lowest ones.
     *
     * @param lowest how many of them do not matter
     */
    private String nothing(ExpressionContext at, int lowest) {
        ExpressionContext expression = bare(at);
        if (expression instanceof BitExpressionContext bits && bits.op.getText().equals("|")) {
            return nothing(bits.expression(0), lowest)
                    + " && "
                    + nothing(bits.expression(1), lowest);
        } else if (expression instanceof BitExpressionContext bits
                && bits.op.getText().equals("^")
                && lowest == 0) {
            return text(bits.expression(0)) + " == " + text(bits.expression(1));
        } else if (expression instanceof ShiftExpressionContext shift
                && !shift.shift().getText().equals("<<")
                && lowest == 0
                && distance(shift).isPresent()) {
            return nothing(shift.expression(0), distance(shift).get());
        }
        String value = text(expression);
        return lowest == 0
                ? value + " == 0"
                : value + " >= 0 && " + value + " < " + power(lowest, kinds.of(expression));
    }

    private Optional<Number> constant(ExpressionContext expression) {
        return new Arithmetic(scope.known()).number(expression);
    }

    private static ExpressionContext bare(ExpressionContext expression) {
        return expression instanceof BracketExpressionContext bracket
                ? bare(bracket.expression())
                : expression;
    }

    private String text(ExpressionContext expression) {
        String text = writer.write(bare(expression));
        return text.matches("\\w+") ? text : "(" + Guards.bare(text) + ")";
    }

    /**
     * A number that is too large for an Integer is a Long, with which an Integer is compared as
     * well.
     */
    private static String power(int exponent, Kind kind) {
        return literal(1L << exponent, exponent > 30 ? Kind.LONG : kind);
    }

    private static String literal(long number, Kind kind) {
        return number + (kind == Kind.LONG ? "L" : "");
    }
}
