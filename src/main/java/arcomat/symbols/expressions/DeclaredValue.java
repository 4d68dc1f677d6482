package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;
import arcomat.tree.Name;

import java.util.Optional;
import java.util.function.BiFunction;

/** A name with a type and, perhaps, a value to begin with. */
public abstract sealed class DeclaredValue implements ValueSymbol
        permits VariableSymbol, ParameterSymbol {
    private final Name name;
    private final Resolution<TypeSymbol> typeResolution;
    private final Lazy<Optional<Typed>> initial;

    /**
     * @param typing types an expression for this type, at the place of the declaration
     */
    DeclaredValue(
            Name name,
            Optional<Expression> initial,
            Resolution<TypeSymbol> typeResolution,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        this.name = name;
        this.typeResolution = typeResolution;
        this.initial = new Lazy<>(() -> initial.map(e -> typing.apply(e, type())));
    }

    public final Resolution<TypeSymbol> typeResolution() {
        return typeResolution;
    }

    /**
     * The initial value of a variable, or the default of a parameter. It may read the parameters
     * before it and, in automata, constants of the component.
     */
    public final Optional<Typed> initial() {
        return initial.get();
    }

    @Override
    public final String name() {
        return name.text();
    }

    @Override
    public final TypeSymbol type() {
        return typeResolution.found().orElse(UnknownType.UNKNOWN);
    }

    @Override
    public final Span nameSpan() {
        return name.span();
    }

    @Override
    public final String toString() {
        return name();
    }
}
