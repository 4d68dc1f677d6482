package arcomat.pipeline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Folders outside of which nothing is read, for whoever serves somebody he does not trust with the
 * whole disk. What counts is where a path leads, by whatever links and dots. Files that change
 * while they are read are not its business: who can put links into the folders has a way out.
 */
public final class Fence {
    /** Where everything may be read. */
    public static final Fence NONE = new Fence(List.of(), "");

    private final List<Path> folders;
    private final String shown;

    private Fence(List<Path> folders, String shown) {
        this.folders = folders;
        this.shown = shown;
    }

    /**
     * @param folders that may be read with all below them, at least one
     * @param shown as the user wrote them
     */
    public static Fence around(List<Path> folders, List<String> shown) {
        if (folders.isEmpty()) {
            throw new IllegalArgumentException("a fence around nothing");
        }
        return new Fence(folders.stream().map(PathNames::real).toList(), String.join(", ", shown));
    }

    /** Whether a path, if anything is there, leads to what may be read. */
    public boolean permits(Path path) {
        if (folders.isEmpty()) {
            return true;
        }
        Path place = place(path.toAbsolutePath());
        return folders.stream().anyMatch(place::startsWith);
    }

    /** What is said of a path that leads elsewhere, behind its name. */
    public String refusal() {
        return "leads out of " + shown + ", and nothing else is read here";
    }

    /** What is not there would be in the last folder that is. */
    private static Path place(Path path) {
        Path there = path;
        while (!Files.exists(there, LinkOption.NOFOLLOW_LINKS)) {
            there = Objects.requireNonNull(there.getParent());
        }
        try {
            return there.toRealPath().resolve(there.relativize(path)).normalize();
        } catch (IOException leadsNowhere) {
            return Objects.requireNonNull(there.getRoot());
        }
    }
}
