package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.Lazy;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;
import arcomat.tree.Variable;

import java.util.Optional;
import java.util.function.BiFunction;

/** A variable of an automaton, or a variable of a component that its automata share. */
public final class VariableSymbol implements ValueSymbol {
    /** Where a variable is declared. */
    public enum Kind {
        /** Read and written by its automaton. */
        AUTOMATON,
        /** A constant for the automata of the component. */
        COMPONENT
    }

    private final Kind kind;
    private final Variable node;
    private final Resolution<TypeSymbol> typeResolution;
    private final Lazy<Optional<Typed>> initial;

    /**
     * @param typing types an expression for this type, at the place of the variable
     */
    public VariableSymbol(
            Kind kind,
            Variable node,
            Resolution<TypeSymbol> typeResolution,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        this.kind = kind;
        this.node = node;
        this.typeResolution = typeResolution;
        this.initial = new Lazy<>(() -> node.initial().map(e -> typing.apply(e, type())));
    }

    public Kind kind() {
        return kind;
    }

    public Variable node() {
        return node;
    }

    public Resolution<TypeSymbol> typeResolution() {
        return typeResolution;
    }

    /** The initial value. It may read parameters and, in automata, constants of the component. */
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
