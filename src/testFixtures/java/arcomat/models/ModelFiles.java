package arcomat.models;

import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The files of a model root and what they need of the library, for tests without a pipeline. */
public final class ModelFiles {
    public static final Path LIBRARY = Path.of("lejos-runtime/nxt/src/main/arc");

    private static final String LANGUAGES = ".*\\.(arc|cd|mt|ioautomaton)";

    private ModelFiles() {}

    /** Ordered; paths are relative to their root, those of the library come last. */
    public static List<SourceFile> of(Path root) {
        List<SourceFile> files = new ArrayList<>(under(root));
        List<SourceFile> open = under(LIBRARY);
        List<SourceFile> needed = neededBy(files, open);
        while (!needed.isEmpty()) {
            files.addAll(needed);
            open.removeAll(needed);
            needed = neededBy(files, open);
        }
        return files;
    }

    private static List<SourceFile> neededBy(List<SourceFile> files, List<SourceFile> open) {
        return open.stream()
                .filter(each -> files.stream().anyMatch(file -> names(file, each.path())))
                .toList();
    }

    /** Whether a text has the name, or the wildcard, of what a file defines. */
    private static boolean names(SourceFile file, String path) {
        String name = path.substring(0, path.lastIndexOf('.')).replace('/', '.');
        String wildcard = name.substring(0, name.lastIndexOf('.')) + ".*";
        return file.text().contains("import " + wildcard + ";")
                || Pattern.compile("\\b" + Pattern.quote(name) + "\\b").matcher(file.text()).find();
    }

    /** The files under a folder alone, ordered; paths are relative to it. */
    public static List<SourceFile> under(Path root) {
        try (Stream<Path> files = Files.walk(root)) {
            List<SourceFile> sources = new ArrayList<>();
            for (Path file : files.sorted().toList()) {
                if (file.toString().matches(LANGUAGES)) {
                    String path = root.relativize(file).toString().replace('\\', '/');
                    sources.add(new SourceFile(path, Files.readString(file)));
                }
            }
            return sources;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
