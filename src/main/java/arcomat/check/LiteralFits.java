package arcomat.check;

import arcomat.symbols.ExpressionProblem.Kind;
import arcomat.symbols.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0331: a literal has a value of its type. */
final class LiteralFits implements Check.OnExpression {
    private static final Set<Kind> KINDS = EnumSet.of(Kind.LITERAL_OVERFLOW);

    @Override
    public Law law() {
        return Law.error("ARC0331");
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
