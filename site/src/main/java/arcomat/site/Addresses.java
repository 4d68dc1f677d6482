package arcomat.site;

import java.nio.file.Path;

/** Where a page lies on the site: as in the repository, but for the pages behind findings. */
final class Addresses {
    private static final String EXPLAIN = "src/main/resources/explain/";
    private static final String FINDINGS = "findings/";

    private Addresses() {}

    /** With forward slashes. */
    static String text(Path path) {
        return path.toString().replace('\\', '/');
    }

    /** The address of a text of the repository. */
    static String of(Path manuscript) {
        return text(manuscript)
                .replaceFirst("^" + EXPLAIN, FINDINGS)
                .replaceFirst("README\\.md$", "index.html")
                .replaceFirst("\\.md$", ".html");
    }

    /** The page about a finding. */
    static String ofFinding(String code) {
        return FINDINGS + code + ".html";
    }

    /** From one address of the site to another one, or to a folder. */
    static String between(String from, String to) {
        Path folder = Path.of("/").resolve(from).resolveSibling("");
        String way = text(folder.relativize(Path.of("/" + to)));
        return way.isEmpty() ? "." : way;
    }
}
