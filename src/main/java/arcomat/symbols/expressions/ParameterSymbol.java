package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;
import arcomat.tree.Parameter;

import java.util.Optional;
import java.util.function.BiFunction;

/** A configuration parameter of a component. */
public final class ParameterSymbol implements ValueSymbol {
    private final Parameter node;
    private final Resolution<TypeSymbol> typeResolution;
    private final Lazy<Optional<Typed>> initial;

    /**
     * @param typing types an expression for this type, at the place of the parameter
     */
    public ParameterSymbol(
            Parameter node,
            Resolution<TypeSymbol> typeResolution,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        this.node = node;
        this.typeResolution = typeResolution;
        this.initial = new Lazy<>(() -> node.initial().map(e -> typing.apply(e, type())));
    }

    public Parameter node() {
        return node;
    }

    public Resolution<TypeSymbol> typeResolution() {
        return typeResolution;
    }

    /** The default value. It may read the parameters before this one. */
    public Optional<Typed> initial() {
        return initial.get();
    }

    @Override
    public String name() {
        return node.name().text();
    }

    @Override
    public TypeSymbol type() {
        return typeResolution.found().orElse(UnknownType.UNKNOWN);
    }

    @Override
    public Span nameSpan() {
        return node.name().span();
    }

    @Override
    public String toString() {
        return name();
    }
}
