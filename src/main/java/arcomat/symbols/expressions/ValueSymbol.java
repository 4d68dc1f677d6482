package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.TypeSymbol;

/** What a simple name in an expression or an item can mean. */
public sealed interface ValueSymbol permits PortSymbol, VariableSymbol, ParameterSymbol {
    String name();

    /** Unknown where the written type does not resolve. */
    TypeSymbol type();

    /** Where the name is declared; for an implicit name, where its type is. */
    Span nameSpan();
}
