package montiarc7.source;

import montiarc7.grammar.MontiArc7Parser.BinaryExpressionContext;
import montiarc7.grammar.MontiArc7Parser.BracketExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ChoiceExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ExpressionContext;
import montiarc7.grammar.MontiArc7Parser.PrefixExpressionContext;

import java.math.BigInteger;
import java.util.Optional;

/**
 * What is known of a condition before anybody chooses features: its truth, where it is the same for
 * all choices.
 */
public final class Constants {
    private Constants() {}

    /** The truth of a condition; nothing where it depends on something. */
    public static Optional<Boolean> truth(ExpressionContext expression) {
        if (expression instanceof BracketExpressionContext bracket) {
            return truth(bracket.expression());
        } else if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("!")) {
            return truth(prefix.expression()).map(each -> !each);
        } else if (expression instanceof ChoiceExpressionContext choice) {
            return truth(choice.expression(0))
                    .flatMap(each -> truth(choice.expression(each ? 1 : 2)));
        } else if (expression instanceof BinaryExpressionContext binary) {
            return comparison(binary).or(() -> connective(binary));
        }
        return Optional.of(expression.getText())
                .filter(each -> each.matches("true|false"))
                .map(Boolean::valueOf);
    }

    private static Optional<Boolean> connective(BinaryExpressionContext binary) {
        Optional<Boolean> left = truth(binary.expression(0));
        Optional<Boolean> right = truth(binary.expression(1));
        return switch (binary.op.getText()) {
            case "&&" -> not(either(not(left), not(right)));
            case "||" -> either(left, right);
            case "implies" -> either(not(left), right);
            case "<=>", "==" -> left.flatMap(each -> right.map(each::equals));
            case "!=" -> left.flatMap(each -> right.map(other -> !each.equals(other)));
            default -> Optional.empty();
        };
    }

    private static Optional<Boolean> either(Optional<Boolean> left, Optional<Boolean> right) {
        if (left.equals(Optional.of(true)) || right.equals(Optional.of(true))) {
            return Optional.of(true);
        }
        return left.isPresent() && right.isPresent() ? Optional.of(false) : Optional.empty();
    }

    private static Optional<Boolean> not(Optional<Boolean> truth) {
        return truth.map(each -> !each);
    }

    private static Optional<Boolean> comparison(BinaryExpressionContext binary) {
        return number(binary.expression(0))
                .flatMap(
                        left ->
                                number(binary.expression(1))
                                        .flatMap(right -> compared(left, binary, right)));
    }

    private static Optional<Boolean> compared(
            BigInteger left, BinaryExpressionContext binary, BigInteger right) {
        int order = left.compareTo(right);
        return switch (binary.op.getText()) {
            case "==" -> Optional.of(order == 0);
            case "!=" -> Optional.of(order != 0);
            case "<" -> Optional.of(order < 0);
            case "<=" -> Optional.of(order <= 0);
            case ">" -> Optional.of(order > 0);
            case ">=" -> Optional.of(order >= 0);
            default -> Optional.empty();
        };
    }

    /** A whole number as it is written, or its negation: nothing is computed. */
    private static Optional<BigInteger> number(ExpressionContext expression) {
        if (expression instanceof BracketExpressionContext bracket) {
            return number(bracket.expression());
        } else if (expression instanceof PrefixExpressionContext prefix
                && prefix.op.getText().equals("-")) {
            return number(prefix.expression()).map(BigInteger::negate);
        }
        return Optional.of(expression.getText())
                .filter(each -> each.matches("0|[1-9][0-9]*"))
                .map(BigInteger::new);
    }
}
