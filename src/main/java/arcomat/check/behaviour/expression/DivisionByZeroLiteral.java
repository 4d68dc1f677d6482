package arcomat.check.behaviour.expression;

import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.tree.TestSuite;

/**
 * ARC0323: no whole number is divided by a zero that is written or computed from what is written.
 * Messages and arguments of tests are computed before anything runs: there, every divisor has to be
 * known.
 */
public final class DivisionByZeroLiteral extends ProblemLaw {
    DivisionByZeroLiteral() {
        super(Kind.DIVISION_BY_ZERO);
    }

    @Override
    public void check(Typed typed, Context context, Findings findings) {
        super.check(typed, context, findings);
        if (context.unit().definition() instanceof TestSuite) {
            typed.expression().walk(part -> checkDivisor(part, findings));
        }
    }

    private static void checkDivisor(TypedExpression expression, Findings findings) {
        if (expression instanceof TypedExpression.Binary binary
                && binary.node().operator().divides()
                && binary.operandType().isIntegral()
                && ConstantFolding.computed(binary.right()).isEmpty()) {
            findings.report(
                    binary.right().node(),
                    "whether this divisor is zero shows only in a run; write the number");
        }
    }
}
