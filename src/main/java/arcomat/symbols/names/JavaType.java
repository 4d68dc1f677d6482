package arcomat.symbols.names;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A type of the Java library. Models know its name: messages are passed on and compared, and nobody
 * looks into them.
 *
 * @param qualifiedName {@code java.util.List}
 * @param arguments empty for a type that takes none, or is written without them
 */
public record JavaType(String qualifiedName, List<Argument> arguments) implements TypeSymbol {
    public JavaType {
        arguments = List.copyOf(arguments);
    }

    /** How a type argument says which types are meant. */
    public enum Bound {
        EXACT(""),
        EXTENDS("? extends "),
        SUPER("? super "),
        ANY("?");

        private final String words;

        Bound(String words) {
            this.words = words;
        }

        /** As Java writes it in front of a type. */
        public String words() {
            return words;
        }
    }

    /**
     * A type argument.
     *
     * @param type of no meaning for {@link Bound#ANY}
     */
    public record Argument(Bound bound, TypeSymbol type) {
        private boolean isErroneous() {
            return bound != Bound.ANY && type.isErroneous();
        }

        private String text() {
            return bound == Bound.ANY ? bound.words() : bound.words() + type.text();
        }
    }

    /** The name without its package. */
    public String simpleName() {
        return qualifiedName.substring(qualifiedName.lastIndexOf('.') + 1);
    }

    /** Whether Java's class for a built-in type is one of these. */
    public boolean isAbove(BuiltinType type) {
        return switch (qualifiedName) {
            case "java.lang.Object", "java.io.Serializable" -> true;
            case "java.lang.Comparable" ->
                    arguments.stream()
                            .filter(each -> each.bound() == Bound.EXACT)
                            .allMatch(each -> each.isErroneous() || each.type().equals(type));
            case "java.lang.Number" -> type.isNumber() && type != BuiltinType.CHARACTER;
            case "java.lang.CharSequence" -> type == BuiltinType.STRING;
            default -> false;
        };
    }

    @Override
    public String text() {
        return arguments.isEmpty()
                ? simpleName()
                : arguments.stream()
                        .map(Argument::text)
                        .collect(Collectors.joining(", ", simpleName() + "<", ">"));
    }

    @Override
    public boolean isObject() {
        return true;
    }

    @Override
    public boolean isErroneous() {
        return arguments.stream().anyMatch(Argument::isErroneous);
    }

    @Override
    public String toString() {
        return text();
    }
}
