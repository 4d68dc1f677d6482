package arcomat.symbols.expressions;

import arcomat.source.Span;
import arcomat.symbols.names.TypeSymbol;

import java.util.function.Function;

/** What a simple name in an expression or an item can mean. */
public sealed interface ValueSymbol permits PortSymbol, DeclaredValue {
    String name();

    /** Unknown where the written type does not resolve. */
    TypeSymbol type();

    /** Where the name is declared; for an implicit name, where its type is. */
    Span nameSpan();

    /** Takes the sum apart: one answer for each form. */
    <R> R match(
            Function<PortSymbol, R> port,
            Function<VariableSymbol, R> variable,
            Function<ParameterSymbol, R> parameter);
}
