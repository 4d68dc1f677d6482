package arcomat.symbols.bodies;

import arcomat.source.ArrayNames;
import arcomat.tree.Name;

import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import java.util.stream.IntStream;

/**
 * Ends of connectors that name a whole array, of ports, or of parts: each element is connected by
 * itself.
 *
 * @param ports whether the component has one of a name
 * @param parts whether it has one of a name
 * @param portsOfParts whether a part has a port
 */
record WholeArrays(
        Predicate<String> ports,
        Predicate<String> parts,
        BiPredicate<String, String> portsOfParts) {

    /** The names of all elements, in their order; none where no array is named. */
    List<List<Name>> elements(List<Name> path) {
        Name first = path.get(0);
        return switch (path.size()) {
            case 1 -> numbered(first, ports).stream().map(List::of).toList();
            case 2 ->
                    names(first, parts).stream()
                            .flatMap(part -> ofPart(part, path.get(1)).stream())
                            .toList();
            default -> List.of();
        };
    }

    private List<List<Name>> ofPart(Name part, Name port) {
        return names(port, name -> portsOfParts.test(part.text(), name)).stream()
                .map(each -> List.of(part, each))
                .toList();
    }

    private static List<Name> names(Name name, Predicate<String> exists) {
        return exists.test(name.text()) ? List.of(name) : numbered(name, exists);
    }

    private static List<Name> numbered(Name array, Predicate<String> exists) {
        return IntStream.range(0, ArrayNames.MOST)
                .mapToObj(index -> ArrayNames.element(array.text(), index))
                .takeWhile(exists)
                .map(name -> new Name(array.span(), name))
                .toList();
    }
}
