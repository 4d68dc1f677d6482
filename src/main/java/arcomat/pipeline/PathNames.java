package arcomat.pipeline;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Paths as the user sees them: relative to the folder the command was started in, unless they were
 * written absolute, and with forward slashes everywhere.
 *
 * @param directory the folder that relative paths start from, absolute
 */
record PathNames(Path directory) {
    Path resolve(String written) {
        return directory.resolve(written);
    }

    String shown(Path path, boolean absolute) {
        Path normal = path.normalize();
        Path shown = absolute ? normal : directory.relativize(normal);
        String text = shown.toString().replace('\\', '/');
        return text.isEmpty() ? "." : text;
    }

    /** The one name of a file, whatever links lead to it. */
    static Path real(Path path) {
        try {
            return path.toRealPath();
        } catch (IOException unreadable) {
            return path.toAbsolutePath().normalize();
        }
    }
}
