package arcomat.pipeline.check;

import arcomat.pipeline.KeptFolder;

import java.io.IOException;
import java.nio.file.Path;

/**
 * The library's models as files that cannot be written, for programs that open files. They lie
 * among temporary files, beside those that guests have brought.
 */
public final class LibraryFolder {
    private static final String PREFIX = KeptFolder.LIBRARY;

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
        return KeptFolder.written(PREFIX, Library.texts());
    }
}
