package arcomat.symbols;

import arcomat.source.Span;
import arcomat.tree.Parameter;

import java.util.Optional;

/** A configuration parameter of a component. */
public final class ParameterSymbol implements ValueSymbol {
    private final Parameter node;
    private final Resolution<TypeSymbol> typeResolution;
    private final Lazy<Optional<Typed>> initial;

    ParameterSymbol(Parameter node, Resolution<TypeSymbol> typeResolution, ValueScope scope) {
        this.node = node;
        this.typeResolution = typeResolution;
        this.initial =
                new Lazy<>(() -> node.initial().map(e -> ExpressionTyping.type(e, scope, type())));
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
