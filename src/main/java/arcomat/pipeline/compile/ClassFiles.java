package arcomat.pipeline.compile;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Classes that compiled code may refer to. Names have slashes: {@code java/util/List}.
 *
 * @param find the class file of a name
 * @param isPackage whether there are classes in a package or below it
 */
public record ClassFiles(Function<String, Optional<byte[]>> find, Predicate<String> isPackage) {
    /** What this program itself runs on, as far as generated code may use it. */
    public static final ClassFiles RUNTIME =
            ofThisProgram(List.of("java/", "arcomat/rt/"), withJava("arcomat", "arcomat/rt"));

    /** Packages, and those of Java that a model may name types of. */
    private static Set<String> withJava(String... packages) {
        Stream<String> ofJava =
                Object.class.getModule().getPackages().stream()
                        .filter(each -> each.startsWith("java."))
                        .map(each -> each.replace('.', '/'));
        return Stream.of(Stream.of("java"), Stream.of(packages), ofJava)
                .flatMap(each -> each)
                .collect(Collectors.toUnmodifiableSet());
    }

    /**
     * Classes that this program has, too.
     *
     * @param prefixes of their names
     * @param packages of those that are looked for
     */
    public static ClassFiles ofThisProgram(List<String> prefixes, Set<String> packages) {
        return new ClassFiles(
                name ->
                        prefixes.stream().anyMatch(name::startsWith)
                                ? read(name)
                                : Optional.empty(),
                packages::contains);
    }

    private static Optional<byte[]> read(String name) {
        ClassLoader loader = ClassFiles.class.getClassLoader();
        try (InputStream in = loader.getResourceAsStream(name + ".class")) {
            return in == null ? Optional.empty() : Optional.of(in.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
