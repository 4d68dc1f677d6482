package arcomat.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * What pages are made of. Paths are relative to it.
 *
 * @param home where everybody can look at its files
 */
record Repository(Path root, String home) {
    static final Path README = Path.of("README.md");
    static final Path CONTENTS = Path.of("docs/README.md");

    Path file(Path path) {
        return root.resolve(path);
    }

    String read(Path path) throws IOException {
        return Files.readString(file(path));
    }

    boolean isFile(Path path) {
        return Files.isRegularFile(file(path));
    }

    boolean isFolder(Path path) {
        return Files.isDirectory(file(path));
    }

    /** Where a file or folder that is no page is looked at. */
    String outside(Path path) {
        return home + (isFolder(path) ? "/tree/main/" : "/blob/main/") + Addresses.text(path);
    }

    /** Files below a folder whose names end so, sorted. */
    List<Path> below(String folder, String... ends) throws IOException {
        try (Stream<Path> files = Files.walk(root.resolve(folder))) {
            return files.map(root::relativize)
                    .filter(path -> Stream.of(ends).anyMatch(path.toString()::endsWith))
                    .filter(path -> Stream.of("build", "out").noneMatch(isPartOf(path)))
                    .sorted()
                    .toList();
        }
    }

    private static Predicate<String> isPartOf(Path path) {
        return name -> ("/" + Addresses.text(path)).contains("/" + name + "/");
    }
}
