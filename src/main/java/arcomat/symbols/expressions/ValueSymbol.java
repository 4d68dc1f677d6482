package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Expression;

/** What a simple name in an expression or an item can mean. */
public sealed interface ValueSymbol permits PortSymbol, DeclaredValue, BoundValue {
    String name();

    /** Unknown where the written type does not resolve. */
    TypeSymbol type();

    /** Where the name is declared; for an implicit name, where its type is. */
    Span nameSpan();

    /** The expression that names it. */
    TypedExpression read(Expression.Reference node);
}
