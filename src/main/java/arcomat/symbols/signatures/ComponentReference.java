package arcomat.symbols.signatures;

import arcomat.source.Span;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSubstitution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.symbols.names.UnsupportedType;
import arcomat.tree.Argument;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * A component as named somewhere, with type arguments.
 *
 * @param span where it is named
 * @param name as written
 * @param arguments in the order written; unknown types where they do not resolve
 */
public record ComponentReference(
        Span span,
        String name,
        Resolution<Signature> resolution,
        List<Resolution<TypeSymbol>> arguments) {
    public ComponentReference {
        arguments = List.copyOf(arguments);
    }

    /** A super component, seen from the component that extends it. */
    static ComponentReference of(Signature heir, TypeReference reference) {
        return new ComponentReference(
                reference.span(),
                reference.name().text(),
                heir.chosen(
                        ComponentNames.superComponent(heir, reference.name()),
                        heir.node().superArguments().orElse(List.of())),
                resolve(heir, reference.arguments()));
    }

    /**
     * The type of a subcomponent, seen from the component around it.
     *
     * @param given its arguments, which choose its features
     */
    public static ComponentReference inside(
            Signature whole, TypeReference reference, List<Argument> given) {
        return new ComponentReference(
                reference.span(),
                reference.name().text(),
                whole.chosen(whole.resolveComponent(reference.name()), given),
                resolve(whole, reference.arguments()));
    }

    public static List<Resolution<TypeSymbol>> resolve(
            Signature place, List<TypeArgument> arguments) {
        List<Resolution<TypeSymbol>> types = new ArrayList<>();
        for (TypeArgument argument : arguments) {
            if (argument instanceof TypeArgument.Given given) {
                types.add(place.resolveType(given.type()));
            } else {
                types.add(
                        new Resolution.Found<>(
                                new UnsupportedType(
                                        argument.span().text(),
                                        "name the type that the ports of this instance carry")));
            }
        }
        return types;
    }

    public Optional<Signature> component() {
        return resolution.found();
    }

    public List<TypeSymbol> argumentTypes() {
        return arguments.stream().map(a -> a.found().orElse(UnknownType.UNKNOWN)).toList();
    }

    /** What the type parameters of the component stand for. */
    public TypeSubstitution substitution() {
        return component()
                .map(c -> TypeSubstitution.of(c.typeParameters(), argumentTypes()))
                .orElse(TypeSubstitution.NONE);
    }
}
