package arcomat.check;

import arcomat.symbols.ExpressionProblem.Kind;
import arcomat.symbols.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0319: an expression uses no methods and no Java objects. (Wor16 AC5) */
final class SupportedExpression implements Check.OnExpression {
    private static final Set<Kind> KINDS =
            EnumSet.of(Kind.UNSUPPORTED_CALL, Kind.UNSUPPORTED_EXPRESSION);

    @Override
    public Law law() {
        return Law.error("ARC0319");
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
