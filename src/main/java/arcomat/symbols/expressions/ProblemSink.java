package arcomat.symbols.expressions;

import arcomat.tree.Expression;

import java.util.Optional;

/** Where typing leaves what is wrong. */
@FunctionalInterface
interface ProblemSink {
    void report(
            ExpressionProblem.Kind kind,
            Expression at,
            String message,
            Optional<String> suggestion);

    default void report(ExpressionProblem.Kind kind, Expression at, String message) {
        report(kind, at, message, Optional.empty());
    }
}
