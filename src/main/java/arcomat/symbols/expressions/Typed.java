package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToLongFunction;

/**
 * An expression with its types, and what is wrong inside it.
 *
 * @param problems in text order; what they concern has an unknown type, so nothing follows from it
 * @param unfolded what else is written in it
 */
public record Typed(
        TypedExpression expression, List<ExpressionProblem> problems, Unfolded unfolded) {
    public Typed {
        problems = List.copyOf(problems);
    }

    /** The same without a complaint that only follows from another one. */
    public Typed withoutUnknownNames() {
        return isUnknownBareName() ? new Typed(expression, List.of(), unfolded) : this;
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

    /** Where it reads variables, in the order of the text. */
    public List<TypedExpression.VariableRead> variablesRead() {
        List<TypedExpression.VariableRead> reads = new ArrayList<>();
        expression.walk(
                part -> {
                    if (part instanceof TypedExpression.VariableRead read) {
                        reads.add(read);
                    }
                });
        return reads;
    }

    /**
     * How large it is, written out.
     *
     * @param sizes of its parts: 1, or more for a name that stands for something else
     * @param most beyond it, it does not matter how far; so nothing overflows
     */
    public long size(ToLongFunction<TypedExpression> sizes, long most) {
        long[] size = {0};
        expression.walk(part -> size[0] = Math.min(most, size[0] + sizes.applyAsLong(part)));
        return size[0];
    }

    /** Whether it may be assigned to a type; also true where a problem is reported anyway. */
    public boolean isAssignableTo(TypeSymbol target) {
        return TypeRules.isAssignable(expression, target);
    }
}
