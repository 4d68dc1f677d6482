package arcomat.syntax;

import arcomat.source.SourceFile;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** The sample files of this room's tests. */
final class Samples {
    private static final Path ROOT = Path.of("src/test/resources/syntax");

    /** Set to write what is seen as what is expected from now on. */
    static final boolean REFRESH = System.getenv("ARCOMAT_REFRESH") != null;

    private Samples() {}

    /** The files of a folder in the order of their names, those with an ending left out. */
    static List<Path> in(String folder, String exceptEnding) {
        try (var files = Files.list(ROOT.resolve(folder))) {
            return files.filter(f -> !f.toString().endsWith(exceptEnding)).sorted().toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static SourceFile file(Path path) {
        return new SourceFile(path.getFileName().toString(), read(path));
    }

    static String read(Path path) {
        try {
            return Files.readString(path);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static void write(Path path, String text) {
        try {
            Files.writeString(path, text);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
