package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ExpressionProblem.Kind;

/** ARC0346: the name that a quantifier or a {@code let} gives hides no other one, and is used. */
public final class BoundNameFree extends ProblemLaw {
    BoundNameFree() {
        super(Kind.BOUND_NAME);
    }
}
