package arcomat.check.behaviour.expression;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.ExpressionProblem;
import arcomat.symbols.expressions.ExpressionProblem.Kind;

/** ARC0329: the names in an expression mean something. (Wor16 AR1) */
public final class NameExists extends ProblemLaw {

    NameExists() {
        super(
                Kind.UNKNOWN_NAME,
                Kind.AMBIGUOUS_NAME,
                Kind.UNKNOWN_CONSTANT,
                Kind.UNKNOWN_ATTRIBUTE);
    }

    /**
     * What exists but is read too early is the business of {@link InitialReadsNoInput}; what may be
     * declared in a component that cannot be read is nobody's.
     */
    @Override
    boolean isOwn(ExpressionProblem problem, Context context) {
        return InitialReadsNoInput.readTooEarly(problem, context).isEmpty()
                && !mayBeInherited(problem, context);
    }

    private static boolean mayBeInherited(ExpressionProblem problem, Context context) {
        return problem.kind() == Kind.UNKNOWN_NAME
                && context.component().filter(ComponentSymbol::lacksAncestor).isPresent();
    }
}
