package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A folder that is made once, with all its files or not at all, and belongs to the user from then
 * on: nothing in it is ever overwritten.
 */
public final class NewFolder {
    private NewFolder() {}

    /**
     * Makes it.
     *
     * @param shown the folder as the user wrote it
     * @param files texts by path, relative to the folder with forward slashes
     * @throws WrongUse where there is something of that name that is no empty folder, or where it
     *     cannot be written
     */
    public static void create(String shown, Map<String, String> files, PathNames names)
            throws WrongUse {
        Path folder = names.resolve(shown).toAbsolutePath().normalize();
        try {
            refuseOthers(folder, shown);
            Files.createDirectories(folder.getParent());
            write(folder, files);
        } catch (IOException e) {
            throw Failures.cannot("write to", shown, e);
        }
    }

    /**
     * Asks whether it can be made, before there are files for it.
     *
     * @param shown the folder as the user wrote it
     * @throws WrongUse where there is something of that name that is no empty folder
     */
    public static void requireFree(Path folder, String shown) throws WrongUse {
        try {
            refuseOthers(folder, shown);
        } catch (IOException e) {
            throw Failures.cannot("write to", shown, e);
        }
    }

    private static void refuseOthers(Path folder, String shown) throws IOException, WrongUse {
        if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
            throw new WrongUse("there is a '%s' already; take another name", shown);
        }
        try (Stream<Path> entries = Files.list(folder)) {
            if (entries.findAny().isPresent()) {
                throw new WrongUse(
                        "the folder '%s' is not empty; take another name, or move what is in it"
                                + " away",
                        shown);
            }
        }
    }

    /** What is complete takes the place of the empty folder, if there is one. */
    private static void write(Path folder, Map<String, String> files) throws IOException {
        Path fresh =
                Files.createTempDirectory(
                        folder.getParent(), "." + folder.getFileName() + ".arcomat-new-");
        try {
            Path complete = Files.createDirectory(fresh.resolve("complete"));
            for (Map.Entry<String, String> file : files.entrySet()) {
                Path path = complete.resolve(file.getKey());
                Files.createDirectories(path.getParent());
                Files.writeString(path, file.getValue(), StandardCharsets.UTF_8);
            }
            Files.move(complete, folder, StandardCopyOption.REPLACE_EXISTING);
        } finally {
            OutputFolder.delete(fresh);
        }
    }
}
