package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0330: operators and casts are used on the types that they are made for. */
public final class OperandTypes implements Check.OnExpression {
    private static final Set<Kind> KINDS =
            EnumSet.of(Kind.OPERAND_TYPE, Kind.CAST, Kind.ABSENCE_OF_NO_PORT);

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        Expressions.report(typed, KINDS, findings);
    }
}
