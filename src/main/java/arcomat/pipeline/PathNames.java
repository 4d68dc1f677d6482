package arcomat.pipeline;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Paths as the user sees them: relative to the folder the command was started in, unless they were
 * written absolute, and with forward slashes everywhere.
 *
 * @param directory the folder that relative paths start from, absolute
 * @param fence what may be read, whoever wrote the path
 */
public record PathNames(Path directory, Fence fence) {
    /** Where everything may be read that the user may read. */
    public PathNames(Path directory) {
        this(directory, Fence.NONE);
    }

    /** The place of a path as the user wrote it. */
    public Path resolve(String written) {
        return directory.resolve(written);
    }

    /**
     * The place of a path as the user wrote it, which is about to be read.
     *
     * @throws WrongUse where it may not be
     */
    public Path readable(String written) throws WrongUse {
        Path path = resolve(written);
        if (!fence.permits(path)) {
            throw new WrongUse("'" + written + "' " + fence.refusal());
        }
        return path;
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
