package arcomat.check;

import arcomat.symbols.DefinedType;
import arcomat.symbols.TypeSymbol;

/** How messages name types. */
final class Types {
    private Types() {}

    /** The name of a type; with its package where another type of the message has the same. */
    static String distinct(TypeSymbol type, TypeSymbol other) {
        boolean same = type.text().equals(other.text());
        return same && type instanceof DefinedType defined ? defined.qualifiedName() : type.text();
    }
}
