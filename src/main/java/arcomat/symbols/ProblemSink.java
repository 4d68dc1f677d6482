package arcomat.symbols;

import arcomat.tree.Expression;

/** Where typing leaves what is wrong. */
@FunctionalInterface
interface ProblemSink {
    void report(ExpressionProblem.Kind kind, Expression at, String message);
}
