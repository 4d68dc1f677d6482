package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0331: a literal has a value of its type. */
public final class LiteralFits implements Check.OnExpression {
    private static final Set<Kind> KINDS = EnumSet.of(Kind.LITERAL_OVERFLOW);

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
