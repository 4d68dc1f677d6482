package arcomat.site;

import java.nio.file.Path;
import java.util.Optional;

/**
 * What a link means within the repository.
 *
 * @param anchor the heading, with its {@code #}, or nothing
 */
record Target(Path path, String anchor) {
    /** Empty where it leads out. */
    static Optional<Target> of(String destination, Path page) {
        if (destination.matches("[a-z]+:.*")) {
            return Optional.empty();
        }
        int at = destination.indexOf('#');
        String file = at < 0 ? destination : destination.substring(0, at);
        String anchor = at < 0 ? "" : destination.substring(at);
        Path path =
                file.isEmpty() ? page : Path.of("/").resolve(page).resolveSibling(file).normalize();
        return Optional.of(
                new Target(path.isAbsolute() ? Path.of("/").relativize(path) : path, anchor));
    }

    /** The text behind it: the file itself, or the one that tells about the folder. */
    Optional<Path> text(Repository repository) {
        Path file = repository.isFolder(path) ? path.resolve("README.md") : path;
        return Optional.of(file)
                .filter(each -> each.toString().endsWith(".md"))
                .filter(repository::isFile);
    }
}
