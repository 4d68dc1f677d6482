package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;

/**
 * Rows of one of the operators {@code &&} and {@code ||}, which the parser makes a tree that is as
 * deep as the row is long.
 */
final class Rows {
    private static final Set<String> ROWS = Set.of("&&", "||");

    private Rows() {}

    /** Whether an operation is a row of more than two operands. */
    static boolean goesOn(ArcomatParser.BinaryExpressionContext context) {
        return isPart(context.left, context) && ROWS.contains(context.operator.getText());
    }

    /** The operands of a row. */
    static List<ArcomatParser.ExpressionContext> operands(
            ArcomatParser.BinaryExpressionContext context) {
        List<ArcomatParser.ExpressionContext> operands = new ArrayList<>();
        ArcomatParser.ExpressionContext rest = context;
        do {
            ArcomatParser.BinaryExpressionContext row =
                    (ArcomatParser.BinaryExpressionContext) rest;
            operands.add(row.right);
            rest = row.left;
        } while (isPart(rest, context));
        operands.add(rest);
        Collections.reverse(operands);
        return operands;
    }

    private static boolean isPart(
            ArcomatParser.ExpressionContext left, ArcomatParser.BinaryExpressionContext row) {
        return left instanceof ArcomatParser.BinaryExpressionContext inner
                && inner.operator.getType() == row.operator.getType();
    }
}
