package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0319: an expression uses no methods and no Java objects. (Wor16 AC5) */
public final class SupportedExpression implements Check.OnExpression {
    private static final Set<Kind> KINDS =
            EnumSet.of(Kind.UNSUPPORTED_CALL, Kind.UNSUPPORTED_EXPRESSION);

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
