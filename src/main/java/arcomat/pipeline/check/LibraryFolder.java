package arcomat.pipeline.check;

import arcomat.report.text.Sha256;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;

/**
 * The library's models as files that cannot be written, for programs that open files. They lie
 * among temporary files, in a folder named after what is in it, so that it is the same one as long
 * as the library is.
 */
public final class LibraryFolder {
    private static final String PREFIX = "arcomat-library-";

    /** Of a hash: two libraries with the same ones are not to be expected. */
    private static final int DIGITS = 16;

    private LibraryFolder() {}

    /** Whether a file is such a copy, which nobody should change. */
    public static boolean holds(Path file) {
        Path folder = file.toAbsolutePath().normalize().getParent();
        while (folder != null && !isFolder(folder)) {
            folder = folder.getParent();
        }
        return folder != null;
    }

    private static boolean isFolder(Path folder) {
        return folder.getFileName() != null && folder.getFileName().toString().startsWith(PREFIX);
    }

    /**
     * Writes what is not there yet.
     *
     * @return a model root with the library's models, all of them, as they are
     */
    public static Path written() throws IOException {
        Map<String, String> texts = Library.texts();
        Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
        Path folder = temporary.resolve(PREFIX + Sha256.hex(texts.toString()).substring(0, DIGITS));
        return holds(folder, texts) ? folder : write(texts, folder);
    }

    /** Others may write among temporary files: what counts is what is there. */
    private static boolean holds(Path folder, Map<String, String> texts) throws IOException {
        for (Map.Entry<String, String> text : texts.entrySet()) {
            Path file = folder.resolve(text.getKey());
            if (!Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                    || !Files.readString(file).equals(text.getValue())) {
                return false;
            }
        }
        return true;
    }

    /** Written beside it and moved; where that fails, it stays where it was written. */
    private static Path write(Map<String, String> texts, Path folder) throws IOException {
        Path fresh = Files.createTempDirectory(PREFIX);
        for (Map.Entry<String, String> text : texts.entrySet()) {
            Path file = fresh.resolve(text.getKey());
            Files.createDirectories(file.getParent());
            Files.writeString(file, text.getValue());
            // Where a file system knows no such thing, the file can be written; nobody reads it.
            var unused = file.toFile().setReadOnly();
        }
        try {
            return Files.move(fresh, folder, StandardCopyOption.ATOMIC_MOVE);
        } catch (IOException taken) {
            return fresh;
        }
    }
}
