package arcomat.check.behaviour.expression;

import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.expressions.ExpressionProblem;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;

import java.util.EnumSet;
import java.util.Set;

/** ARC0329: the names in an expression mean something. (Wor16 AR1) */
public final class NameExists implements Check.OnExpression {
    private static final Set<Kind> KINDS =
            EnumSet.of(
                    Kind.UNKNOWN_NAME,
                    Kind.AMBIGUOUS_NAME,
                    Kind.UNKNOWN_CONSTANT,
                    Kind.UNKNOWN_ATTRIBUTE);

    /** What exists but is read too early is the business of {@link InitialReadsNoInput}. */
    @Override
    public void check(Typed typed, Context context, Findings findings) {
        for (ExpressionProblem problem : typed.problems()) {
            if (KINDS.contains(problem.kind())
                    && InitialReadsNoInput.readTooEarly(problem, context).isEmpty()) {
                Expressions.report(problem, findings);
            }
        }
    }
}
