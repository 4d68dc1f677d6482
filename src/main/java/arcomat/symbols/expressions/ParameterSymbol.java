package arcomat.symbols.expressions;

import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Parameter;

import java.util.function.BiFunction;
import java.util.function.Function;

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
    public <R> R match(
            Function<PortSymbol, R> port,
            Function<VariableSymbol, R> variable,
            Function<ParameterSymbol, R> parameter) {
        return parameter.apply(this);
    }
}
