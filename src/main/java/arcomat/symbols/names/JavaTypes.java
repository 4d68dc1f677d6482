package arcomat.symbols.names;

import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;

/** What the types of the Java library are as types of messages. */
final class JavaTypes {
    private static final String LANGUAGE = "java.lang.";
    private static final String LIST = "java.util.List";

    private JavaTypes() {}

    /** Whether a full name can only be one of the Java library. */
    static boolean isJava(String name) {
        return name.startsWith("java.") || name.startsWith("javax.");
    }

    /** Whether the library is known to have a type of that full name. */
    static boolean isKnown(String name) {
        return isJava(name) && JavaLibrary.find(name).isPresent();
    }

    /** Whether types of the library are known to be in a package, or in a type, of that name. */
    static boolean isQualifier(String name) {
        return isJava(name) && (JavaLibrary.isPackage(name) || JavaLibrary.find(name).isPresent());
    }

    /** The type of a full name: built in, or known by its name alone. */
    static TypeSymbol named(String name) {
        Optional<BuiltinType> builtin =
                name.startsWith(LANGUAGE)
                        ? BuiltinType.named(name.substring(LANGUAGE.length()))
                        : Optional.empty();
        if (builtin.isPresent()) {
            return builtin.get();
        }
        String simple = name.substring(name.lastIndexOf('.') + 1);
        Optional<JavaLibrary.Entry> entry = JavaLibrary.find(name);
        if (entry.isEmpty()) {
            return new UnsupportedType(
                    name,
                    "it is not known here; write 'type %s;' in a class diagram".formatted(simple));
        }
        if (entry.get().few()) {
            return new UnsupportedType(
                    name,
                    "it has few values, which models have to know; define an enum in a class"
                            + " diagram");
        }
        return new JavaType(name, List.of());
    }

    /**
     * What an array of Java is as a message. Arrays are equal to none but themselves, and messages
     * are equal where they hold the same: so do lists.
     */
    static TypeSymbol listOf(TypeSymbol element) {
        return element instanceof UnsupportedType
                ? element
                : new JavaType(LIST, List.of(new JavaType.Argument(JavaType.Bound.EXACT, element)));
    }

    /** The type with the arguments that are written behind it. */
    static Resolution<TypeSymbol> given(
            JavaType type,
            TypeReference reference,
            Function<QualifiedName, Resolution<TypeSymbol>> names) {
        List<TypeArgument> written = reference.arguments();
        int wanted =
                JavaLibrary.find(type.qualifiedName())
                        .map(JavaLibrary.Entry::arguments)
                        .orElse(written.size());
        if (!written.isEmpty() && written.size() != wanted) {
            return TypeReferences.unsupported(
                    reference,
                    "%s takes %s"
                            .formatted(
                                    type.qualifiedName(),
                                    switch (wanted) {
                                        case 0 -> "no type arguments";
                                        case 1 -> "1 type argument";
                                        default -> wanted + " type arguments";
                                    }));
        }
        if (written.stream().anyMatch(JavaTypes::isNoObject)) {
            return TypeReferences.unsupported(
                    reference,
                    "type arguments are types of objects; write Integer instead of int, without a"
                            + " range");
        }
        List<JavaType.Argument> arguments = new ArrayList<>();
        for (TypeArgument each : written) {
            arguments.add(argument(each, names));
        }
        return new Resolution.Found<>(new JavaType(type.qualifiedName(), arguments));
    }

    private static boolean isNoObject(TypeArgument argument) {
        return argument instanceof TypeArgument.Given given
                && given.type().dimensions() == 0
                && (given.type().range().isPresent()
                        || BuiltinType.isPrimitive(given.type().name().text()));
    }

    private static JavaType.Argument argument(
            TypeArgument written, Function<QualifiedName, Resolution<TypeSymbol>> names) {
        if (written instanceof TypeArgument.Given given) {
            return new JavaType.Argument(JavaType.Bound.EXACT, object(given.type(), names));
        }
        TypeArgument.Wildcard wildcard = (TypeArgument.Wildcard) written;
        if (wildcard.bound().isEmpty()) {
            return new JavaType.Argument(JavaType.Bound.ANY, UnknownType.UNKNOWN);
        }
        return new JavaType.Argument(
                wildcard.upper() ? JavaType.Bound.EXTENDS : JavaType.Bound.SUPER,
                object(wildcard.bound().get(), names));
    }

    /** What is wrong with it is reported where it is written. */
    private static TypeSymbol object(
            TypeReference reference, Function<QualifiedName, Resolution<TypeSymbol>> names) {
        return TypeReferences.resolve(reference, names).found().orElse(UnknownType.UNKNOWN);
    }
}
