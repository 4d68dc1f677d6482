package arcomat.symbols.names;

/** The type of what did not resolve. It fits everywhere, so that one mistake is reported once. */
public enum UnknownType implements TypeSymbol {
    UNKNOWN;

    @Override
    public String text() {
        return "unknown type";
    }
}
