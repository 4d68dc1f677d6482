package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;

import java.util.List;

/**
 * An expression with its types, and what is wrong inside it.
 *
 * @param problems in text order; what they concern has an unknown type, so nothing follows from it
 */
public record Typed(TypedExpression expression, List<ExpressionProblem> problems) {
    public Typed {
        problems = List.copyOf(problems);
    }

    /** The same without a complaint that only follows from another one. */
    public Typed withoutUnknownNames() {
        return isUnknownBareName() ? new Typed(expression, List.of()) : this;
    }

    /** Whether it is a simple name that nothing has: perhaps a constant of some enum. */
    public boolean isUnknownBareName() {
        return expression instanceof TypedExpression.Erroneous
                && expression.node() instanceof Expression.Reference reference
                && reference.name().isSimple();
    }

    public TypeSymbol type() {
        return expression.type();
    }

    /** Whether it may be assigned to a type; also true where a problem is reported anyway. */
    public boolean isAssignableTo(TypeSymbol target) {
        return TypeRules.isAssignable(expression, target);
    }
}
