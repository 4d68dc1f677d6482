package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Rows of one of the operators {@code &&} and {@code ||}, which the parser makes a tree that is as
 * deep as the row is long.
 */
final class Rows {
    private Rows() {}

    /** The operands of a row; those of any other operation are two. */
    static List<ArcomatParser.ExpressionContext> operands(
            ArcomatParser.BinaryExpressionContext context) {
        List<ArcomatParser.ExpressionContext> operands = new ArrayList<>();
        ArcomatParser.ExpressionContext rest = context;
        do {
            ArcomatParser.BinaryExpressionContext row =
                    (ArcomatParser.BinaryExpressionContext) rest;
            operands.add(row.expression(1));
            rest = row.expression(0);
        } while (isRow(context)
                && rest instanceof ArcomatParser.BinaryExpressionContext left
                && left.operator.getType() == context.operator.getType());
        operands.add(rest);
        Collections.reverse(operands);
        return operands;
    }

    private static boolean isRow(ArcomatParser.BinaryExpressionContext context) {
        String operator = ArcomatLexer.VOCABULARY.getLiteralName(context.operator.getType());
        return operator.equals("'&&'") || operator.equals("'||'");
    }
}
