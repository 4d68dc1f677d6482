package arcomat.generate.view;

/**
 * A type that a file mentions.
 *
 * @param packageName of the target, empty for none
 * @param prefix the package as the beginning of an identifier, {@code coffee_types_}
 * @param folder the package as the beginning of a path, {@code coffee/types/}
 * @param neighbour whether it lives in the package of the file
 * @param kind {@code enum}, {@code class} or {@code component}
 */
public record TypeView(
        String packageName,
        String prefix,
        String folder,
        String name,
        boolean neighbour,
        String kind) {}
