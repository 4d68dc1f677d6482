package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ExpressionProblem.Kind;

/** ARC0319: an expression uses no methods and no Java objects. (Wor16 AC5) */
public final class SupportedExpression extends ProblemLaw {

    SupportedExpression() {
        super(Kind.UNSUPPORTED_CALL, Kind.UNSUPPORTED_EXPRESSION);
    }
}
