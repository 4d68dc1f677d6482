package arcomat.check.facts;

import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.TypeSymbol;

/** How messages name types. */
public final class Types {
    private Types() {}

    /** The name of a type; with its package where another type of the message has the same. */
    public static String distinct(TypeSymbol type, TypeSymbol other) {
        boolean same = type.text().equals(other.text());
        return same && type instanceof DefinedType defined ? defined.qualifiedName() : type.text();
    }
}
