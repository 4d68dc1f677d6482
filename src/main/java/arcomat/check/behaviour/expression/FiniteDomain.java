package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ExpressionProblem.Kind;

/**
 * ARC0347: what a quantifier is about, and which element of an array is meant, is known before a
 * run.
 */
public final class FiniteDomain extends ProblemLaw {
    FiniteDomain() {
        super(Kind.DOMAIN);
    }
}
