package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.PosixFilePermission;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;

/** Replaces what is in a file at once: whoever looks sees the old or the new. */
public final class AtomicFile {
    private AtomicFile() {}

    /**
     * Writes a file that a user asks for; folders on the way are made.
     *
     * @param written the file as the user wrote it
     * @throws WrongUse where it cannot be written
     */
    public static void write(String written, String text, PathNames names) throws WrongUse {
        write(written, text.getBytes(StandardCharsets.UTF_8), names);
    }

    /** Writes any bytes to such a file. */
    public static void write(String written, byte[] content, PathNames names) throws WrongUse {
        Path file = names.resolve(written);
        try {
            Files.createDirectories(file.toAbsolutePath().getParent());
            write(file, content);
        } catch (IOException e) {
            throw Failures.cannot("write to", written, e);
        }
    }

    /** Writes a text in UTF-8, as {@link #write(Path, byte[])} does. */
    public static void write(Path file, String text) throws IOException {
        write(file, text.getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Writes a file as a whole; a file that is there keeps its permissions, and stays what it was
     * where writing fails.
     */
    public static void write(Path file, byte[] content) throws IOException {
        // A link stays a link; what it leads to gets the content.
        Path target = Files.exists(file) ? file.toRealPath() : file;
        Path folder = Objects.requireNonNull(target.toAbsolutePath().getParent());
        Path fresh = folder.resolve(".arcomat-" + UUID.randomUUID() + ".tmp");
        try {
            Files.write(fresh, content, StandardOpenOption.CREATE_NEW);
            if (Files.exists(target)) {
                keepPermissions(target, fresh);
            }
            move(fresh, target);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    private static void keepPermissions(Path from, Path to) throws IOException {
        try {
            Set<PosixFilePermission> permissions = Files.getPosixFilePermissions(from);
            Files.setPosixFilePermissions(to, permissions);
        } catch (UnsupportedOperationException notPosix) {
            // Such a file system has no permissions to keep.
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }
}
