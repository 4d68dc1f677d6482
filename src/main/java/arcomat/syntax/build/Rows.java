package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser.BinaryExpressionContext;
import arcomat.syntax.antlr.ArcomatParser.ExpressionContext;

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
    static List<ExpressionContext> operands(BinaryExpressionContext context) {
        List<ExpressionContext> operands = new ArrayList<>();
        ExpressionContext rest = context;
        do {
            BinaryExpressionContext row = (BinaryExpressionContext) rest;
            operands.add(row.expression(1));
            rest = row.expression(0);
        } while (isRow(context)
                && rest instanceof BinaryExpressionContext left
                && left.operator.getType() == context.operator.getType());
        operands.add(rest);
        Collections.reverse(operands);
        return operands;
    }

    private static boolean isRow(BinaryExpressionContext context) {
        String operator = ArcomatLexer.VOCABULARY.getLiteralName(context.operator.getType());
        return operator.equals("'&&'") || operator.equals("'||'");
    }
}
