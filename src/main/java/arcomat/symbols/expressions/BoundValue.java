package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Name;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A name that a quantifier or a {@code let} gives to a value: wherever it is read, the value
 * stands.
 */
final class BoundValue implements ValueSymbol {
    private final Name name;
    private final TypedExpression value;
    private final Consumer<Span> reads;

    /**
     * @param reads is told where each read is
     */
    BoundValue(Name name, TypedExpression value, Consumer<Span> reads) {
        this.name = name;
        this.value = value;
        this.reads = reads;
    }

    @Override
    public String name() {
        return name.text();
    }

    @Override
    public TypeSymbol type() {
        return value.type();
    }

    @Override
    public Span nameSpan() {
        return name.span();
    }

    /** What is constant is at the place where it is read, and is not what is named there. */
    @Override
    public TypedExpression read(Expression.Reference node) {
        reads.accept(node.name().parts().get(0).span());
        if (value instanceof TypedExpression.Literal literal) {
            return new TypedExpression.Literal(place(node), literal.value(), literal.type());
        }
        return value instanceof TypedExpression.Constant constant
                ? new TypedExpression.Constant(
                        place(node), constant.type(), constant.ordinal(), true)
                : value;
    }

    private Expression place(Expression.Reference node) {
        return new Expression.Indexed(
                node.span(),
                List.of(new Expression.Indexed.Step(name.span(), name, Optional.empty())));
    }
}
