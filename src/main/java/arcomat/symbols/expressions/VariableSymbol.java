package arcomat.symbols.expressions;

import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;
import arcomat.tree.Variable;

import java.util.function.BiFunction;

/** A variable of an automaton, of a component beside its automata, or of some statements. */
public final class VariableSymbol extends DeclaredValue {
    /** Where a variable is declared. */
    public enum Kind {
        /** Read and written by its automaton. */
        AUTOMATON,
        /** Read and written by the automaton that writes it; a constant where none does. */
        COMPONENT,
        /** A name for a value among the statements of one step. */
        LOCAL,
        /** Of a suite of tests; stands for its value. */
        SUITE
    }

    private final Kind kind;
    private final Variable node;

    public VariableSymbol(
            Kind kind,
            Variable node,
            Resolution<TypeSymbol> typeResolution,
            BiFunction<Expression, TypeSymbol, Typed> typing) {
        super(node.name(), node.initial(), typeResolution, typing);
        this.kind = kind;
        this.node = node;
    }

    public Kind kind() {
        return kind;
    }

    public Variable node() {
        return node;
    }

    @Override
    public TypedExpression read(Expression.Reference node) {
        return new TypedExpression.VariableRead(node, this);
    }
}
