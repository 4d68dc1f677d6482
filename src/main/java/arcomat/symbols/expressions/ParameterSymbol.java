package arcomat.symbols.expressions;

import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Component.Parameter;
import arcomat.tree.Expression;

import java.util.function.BiFunction;

/** A configuration parameter of a component. */
public final class ParameterSymbol extends DeclaredValue {
    private final Parameter node;

    public ParameterSymbol(
            Parameter node,
            Resolution<TypeSymbol> typeResolution,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        super(node.name(), node.initial(), typeResolution, typing);
        this.node = node;
    }

    public Parameter node() {
        return node;
    }

    @Override
    public TypedExpression read(Expression.Reference node) {
        return new TypedExpression.ParameterRead(node, this);
    }
}
