package arcomat.check;

import arcomat.symbols.ExpressionProblem.Kind;
import arcomat.symbols.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0330: operators and casts are used on the types that they are made for. */
final class OperandTypes implements Check.OnExpression {
    private static final Set<Kind> KINDS =
            EnumSet.of(Kind.OPERAND_TYPE, Kind.CAST, Kind.ABSENCE_OF_NO_PORT);

    @Override
    public Law law() {
        return Law.error("ARC0330");
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
