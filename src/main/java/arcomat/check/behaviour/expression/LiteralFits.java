package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ExpressionProblem.Kind;

/** ARC0331: a literal has a value of its type. */
public final class LiteralFits extends ProblemLaw {

    LiteralFits() {
        super(Kind.LITERAL_OVERFLOW);
    }
}
