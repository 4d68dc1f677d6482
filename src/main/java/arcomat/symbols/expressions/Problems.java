package arcomat.symbols.expressions;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Collects what is wrong in an expression, in the order in which it is typed. */
final class Problems {
    private static final int LONGEST = 40;

    /** Most expressions have none. */
    private List<ExpressionProblem> found = List.of();

    List<ExpressionProblem> found() {
        return found;
    }

    void report(Kind kind, Expression at, String message) {
        report(kind, at, message, Optional.empty());
    }

    void report(Kind kind, Expression at, String message, Optional<String> suggestion) {
        if (found.isEmpty()) {
            found = new ArrayList<>();
        }
        found.add(new ExpressionProblem(kind, at.span(), message, suggestion));
    }

    /** Reports an expression of which nothing is known. */
    TypedExpression erroneous(Kind kind, Expression expression, String message) {
        report(kind, expression, message);
        return new TypedExpression.Erroneous(expression, List.of());
    }

    /** The text of an expression, as it fits into a sentence. */
    static String quoted(Expression expression) {
        String line = expression.span().text().strip().replaceAll("\\s+", " ");
        return line.length() <= LONGEST
                ? "'" + line + "'"
                : "'" + line.substring(0, LONGEST - 2) + "..'";
    }
}
