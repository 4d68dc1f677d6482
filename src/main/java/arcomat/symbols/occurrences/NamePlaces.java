package arcomat.symbols.occurrences;

import arcomat.source.ArrayNames;
import arcomat.source.Span;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.TypeVariable;
import arcomat.symbols.occurrences.Occurrence.Role;
import arcomat.tree.Name;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;

/** Takes down places, in any order. */
final class NamePlaces {
    private final Map<Integer, Occurrence> found = new TreeMap<>();

    List<Occurrence> inTextOrder() {
        return List.copyOf(found.values());
    }

    void declared(Span span, Referent referent) {
        add(span, referent, Role.DECLARES);
    }

    /**
     * What is written once may be read several times, and elements of an array are named together
     * where it is declared, or where a quantifier or a connector is about all of them.
     */
    void add(Span span, Referent referent, Role role) {
        Referent named = Referent.Array.around(referent);
        Span word = named == referent ? span : ArrayNames.word(span, named.name());
        if (!isWritten(word.text(), named)) {
            return;
        }
        found.merge(
                word.start(),
                new Occurrence(word, named, role),
                (first, other) ->
                        first.referent() instanceof Referent.Array array
                                ? new Occurrence(
                                        first.span(), array.and(other.referent()), first.role())
                                : first);
    }

    /** What a guest has made of a text stands at places that need not name it. */
    private static boolean isWritten(String word, Referent named) {
        return named instanceof Referent.Builtin builtin
                ? BuiltinType.named(word).filter(builtin.type()::equals).isPresent()
                : word.equals(named.name());
    }

    /** What a guest has made of its text: those places where the text itself has the name. */
    void addNames(NamePlaces translated) {
        Set<Span> taken = new HashSet<>();
        translated.inTextOrder().stream()
                .filter(each -> each.span().text().equals(each.referent().name()))
                .filter(each -> taken.add(each.span()))
                .forEach(each -> found.putIfAbsent(each.span().start(), each));
    }

    /**
     * A path whose last name stands for something; those in front stand for what it lies in. The
     * diagram of a type may be left out.
     */
    void path(List<Name> names, Referent last) {
        Optional<Referent> current = Optional.of(last);
        for (int i = names.size() - 1; i >= 0 && current.isPresent(); i--) {
            Name name = names.get(i);
            if (current.get() instanceof Referent.Diagram diagram
                    && !name.text().equals(diagram.name())) {
                current = diagram.around();
            }
            current.ifPresent(each -> add(name.span(), each, Role.REFERS));
            current = current.flatMap(Referent::around);
        }
    }

    /** A type as written, with its arguments. */
    void type(TypeReference reference, Function<TypeReference, Resolution<TypeSymbol>> resolution) {
        resolution
                .apply(nameOnly(reference))
                .found()
                .flatMap(NamePlaces::referent)
                .ifPresent(type -> path(reference.name().parts(), type));
        arguments(reference.arguments(), resolution);
    }

    void arguments(
            List<TypeArgument> arguments,
            Function<TypeReference, Resolution<TypeSymbol>> resolution) {
        for (TypeArgument argument : arguments) {
            given(argument).ifPresent(type -> type(type, resolution));
        }
    }

    private static Optional<TypeReference> given(TypeArgument argument) {
        return argument instanceof TypeArgument.Given given
                ? Optional.of(given.type())
                : ((TypeArgument.Wildcard) argument).bound();
    }

    /** What is wrong with the rest, such as brackets of an array, changes no name. */
    private static TypeReference nameOnly(TypeReference reference) {
        return new TypeReference(
                reference.span(), reference.name(), List.of(), Optional.empty(), 0);
    }

    /** Empty for what is no type of models. */
    static Optional<Referent> referent(TypeSymbol type) {
        return builtin(type.base()).or(() -> ofModels(type));
    }

    private static Optional<Referent> builtin(TypeSymbol type) {
        return type instanceof BuiltinType builtin
                ? Optional.of(new Referent.Builtin(builtin))
                : Optional.empty();
    }

    private static Optional<Referent> ofModels(TypeSymbol type) {
        if (type instanceof DefinedType defined) {
            return Optional.of(new Referent.Type(defined));
        }
        return type instanceof TypeVariable variable
                ? Optional.of(new Referent.TypeParameter(variable))
                : Optional.empty();
    }
}
