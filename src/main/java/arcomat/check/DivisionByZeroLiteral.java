package arcomat.check;

import arcomat.symbols.ExpressionProblem.Kind;
import arcomat.symbols.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0323: no whole number is divided by a literal zero. */
final class DivisionByZeroLiteral implements Check.OnExpression {
    private static final Set<Kind> KINDS = EnumSet.of(Kind.DIVISION_BY_ZERO);

    @Override
    public Law law() {
        return Law.error("ARC0323");
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
