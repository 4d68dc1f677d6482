package arcomat.benchmarks.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The classes of a program as Java maps them into memory: the installed tool starts with such a
 * file, and makes it at its first start.
 */
public final class ClassArchive {
    private final Path file;

    private ClassArchive(Path file) {
        this.file = file;
    }

    /**
     * Has a program leave the classes that it has loaded.
     *
     * @param command starts it, with a class path of nothing but archives
     */
    public static ClassArchive leftBy(List<String> command) throws IOException {
        Path folder = Files.createTempDirectory("classes");
        ClassArchive archive = new ClassArchive(folder.resolve("classes.jsa"));
        try {
            Command.run(with("-XX:ArchiveClassesAtExit=" + archive.file, command));
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        if (!Files.exists(archive.file)) {
            throw new IllegalStateException(command + " left no classes");
        }
        archive.file.toFile().deleteOnExit();
        folder.toFile().deleteOnExit();
        return archive;
    }

    /** The command that starts with these classes. */
    public List<String> used(List<String> command) {
        return with("-XX:SharedArchiveFile=" + file, command);
    }

    private static List<String> with(String option, List<String> command) {
        List<String> changed = new ArrayList<>(command);
        changed.add(1, option);
        return changed;
    }
}
