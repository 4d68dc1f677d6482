package arcomat.symbols.names;

/**
 * A type of Java that models cannot use: arrays, library classes, type arguments on a message type.
 *
 * @param text as written
 * @param advice what to do instead, the rest of a sentence
 */
public record UnsupportedType(String text, String advice) implements TypeSymbol {
    @Override
    public String toString() {
        return text;
    }
}
