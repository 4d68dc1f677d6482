package arcomat.pipeline;

import arcomat.source.Sha256;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;
import java.util.Objects;

/**
 * Texts as files that cannot be written, among temporary files, in a folder named after what is in
 * it, so that it is the same one as long as the texts are.
 */
public final class KeptFolder {
    /** What the names of folders with models begin with. */
    public static final String LIBRARY = "arcomat-library-";

    /** Of a hash: two folders with the same ones are not to be expected. */
    private static final int DIGITS = 16;

    private KeptFolder() {}

    /**
     * Writes what is not there yet.
     *
     * @param prefix of the folder's name
     * @param texts by their paths in the folder
     */
    public static Path written(String prefix, Map<String, String> texts) throws IOException {
        Path temporary = Path.of(System.getProperty("java.io.tmpdir"));
        Path folder = temporary.resolve(prefix + Sha256.hex(texts.toString()).substring(0, DIGITS));
        return holds(folder, texts) ? folder : write(prefix, texts, folder);
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
    private static Path write(String prefix, Map<String, String> texts, Path folder)
            throws IOException {
        Path fresh = Files.createTempDirectory(prefix);
        for (Map.Entry<String, String> text : texts.entrySet()) {
            Path file = fresh.resolve(text.getKey());
            Files.createDirectories(Objects.requireNonNull(file.getParent()));
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
