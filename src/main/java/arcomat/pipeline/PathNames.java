package arcomat.pipeline;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Paths as the user sees them: relative to the folder the command was started in, unless they were
 * written absolute, and with forward slashes everywhere.
 *
 * @param directory the folder that relative paths start from, absolute
 */
public record PathNames(Path directory) {
    /** The place of a path as the user wrote it. */
    public Path resolve(String written) {
        return directory.resolve(written);
    }

    /**
     * How a place is shown to the user.
     *
     * @param absolute whether it was written so
     */
    public String shown(Path path, boolean absolute) {
        Path normal = path.normalize();
        Path shown = absolute ? normal : directory.relativize(normal);
        String text = shown.toString().replace('\\', '/');
        return text.isEmpty() ? "." : text;
    }

    /** The one name of a file, whatever links lead to it. */
    public static Path real(Path path) {
        try {
            return path.toRealPath();
        } catch (IOException unreadable) {
            return path.toAbsolutePath().normalize();
        }
    }
}
