package montiarc7.statement;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.grammar.MontiArc7Parser.NameExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;

import java.util.Optional;

/** Values that are known before anything runs: Boolean, Integer or Long, calculated as in Java. */
final class Arithmetic {
    private final Known known;

    Arithmetic(Known known) {
        this.known = known;
    }

    /** Nothing where it depends on what is not known. */
    Optional<Object> value(ExpressionContext expression) {
        if (expression instanceof BracketExpressionContext bracket) {
            return value(bracket.expression());
        } else if (expression instanceof LiteralExpressionContext) {
            return literal(expression.getText());
        } else if (expression instanceof NameExpressionContext) {
            return Optional.ofNullable(known.values().get(expression.getText()));
        } else if (expression instanceof PrefixExpressionContext prefix) {
            return value(prefix.expression()).flatMap(each -> prefix(prefix.op.getText(), each));
        } else if (expression instanceof BinaryExpressionContext binary) {
            return both(binary);
        }
        return Optional.empty();
    }

    Optional<Boolean> truth(ExpressionContext condition) {
        return value(condition).filter(Boolean.class::isInstance).map(Boolean.class::cast);
    }

    Optional<Number> number(ExpressionContext expression) {
        return value(expression).filter(Number.class::isInstance).map(Number.class::cast);
    }

    private static Optional<Object> literal(String text) {
        if (text.matches("true|false")) {
            return Optional.of(text.equals("true"));
        } else if (text.matches("0|[1-9][0-9]{0,8}")) {
            return Optional.of(Integer.valueOf(text));
        } else if (text.matches("(0|[1-9][0-9]{0,17})[lL]")) {
            return Optional.of(Long.valueOf(text.substring(0, text.length() - 1)));
        }
        return Optional.empty();
    }

    private static Optional<Object> prefix(String operator, Object value) {
        if (value instanceof Boolean truth) {
            return operator.equals("!") ? Optional.of(!truth) : Optional.empty();
        }
        return switch (operator) {
            case "-" -> calculated("-", 0, (Number) value);
            case "+" -> Optional.of(value);
            default -> Optional.empty();
        };
    }

    private Optional<Object> both(BinaryExpressionContext binary) {
        String operator = binary.op.getText();
        Optional<Object> left = value(binary.expression(0));
        Optional<Object> right = value(binary.expression(1));
        if (operator.equals("&&") || operator.equals("||")) {
            Object decides = operator.equals("||");
            return left.filter(decides::equals).or(() -> left.flatMap(each -> right));
        }
        return left.flatMap(one -> right.flatMap(other -> calculated(one, operator, other)));
    }

    private static Optional<Object> calculated(Object left, String operator, Object right) {
        return left instanceof Number one && right instanceof Number other
                ? calculated(operator, one, other)
                : Optional.empty();
    }

    static Optional<Object> calculated(String operator, Number left, Number right) {
        long one = left.longValue();
        long other = right.longValue();
        if (operator.matches("[/%]") && other == 0) {
            return Optional.empty();
        }
        Optional<Boolean> compared = compared(operator, one, other);
        if (compared.isPresent()) {
            return Optional.of(compared.get());
        }
        boolean large = left instanceof Long || right instanceof Long;
        return calculated(operator, one, other)
                .map(each -> large ? each : (Object) each.intValue());
    }

    private static Optional<Boolean> compared(String operator, long one, long other) {
        return switch (operator) {
            case "<" -> Optional.of(one < other);
            case "<=" -> Optional.of(one <= other);
            case ">" -> Optional.of(one > other);
            case ">=" -> Optional.of(one >= other);
            case "==" -> Optional.of(one == other);
            case "!=" -> Optional.of(one != other);
            default -> Optional.empty();
        };
    }

    private static Optional<Long> calculated(String operator, long one, long other) {
        return switch (operator) {
            case "+" -> Optional.of(one + other);
            case "-" -> Optional.of(one - other);
            case "*" -> Optional.of(one * other);
            case "/" -> Optional.of(one / other);
            case "%" -> Optional.of(one % other);
            default -> Optional.empty();
        };
    }
}
