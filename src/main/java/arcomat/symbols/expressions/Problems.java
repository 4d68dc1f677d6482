package arcomat.symbols.expressions;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Collects what is wrong in an expression, in the order in which it is typed, and what has no place
 * among its parts.
 */
final class Problems {
    private static final int LONGEST = 40;
    private int grown;
    private boolean isTooLong;

    /** Most expressions have none. */
    private List<ExpressionProblem> found = List.of();

    private Unfolded unfolded = Unfolded.NOTHING;

    List<ExpressionProblem> found() {
        return found;
    }

    Unfolded unfolded() {
        return unfolded;
    }

    /** Where something is to be told of what is known before a run. */
    Unfolded unfolding() {
        if (unfolded == Unfolded.NOTHING) {
            unfolded =
                    new Unfolded(
                            new ArrayList<>(),
                            new ArrayList<>(),
                            new ArrayList<>(),
                            new ArrayList<>());
        }
        return unfolded;
    }

    void report(Kind kind, Expression at, String message) {
        report(kind, at, message, Optional.empty());
    }

    void report(Kind kind, Expression at, String message, Optional<String> suggestion) {
        report(new ExpressionProblem(kind, at.span(), message, suggestion));
    }

    /** Of what is written once and stands for several things, each is told once. */
    void report(ExpressionProblem problem) {
        if (found.isEmpty()) {
            found = new ArrayList<>();
        }
        if (!found.contains(problem)) {
            found.add(problem);
        }
    }

    /** Whether an expression may become that much longer than it is written; told once if not. */
    boolean mayGrow(Expression at, int more) {
        if (!isTooLong && more > QuantifierTyping.MOST - grown) {
            isTooLong = true;
            report(
                    Kind.DOMAIN,
                    at,
                    "this stands for more than 1,000 conditions; say it of fewer values, or keep"
                            + " part of it in a variable");
        }
        grown += isTooLong ? 0 : more;
        return !isTooLong;
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
