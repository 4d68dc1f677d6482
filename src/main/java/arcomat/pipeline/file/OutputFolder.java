package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * A folder of generated files, replaced as a whole or not at all. A list inside it, {@value #LIST},
 * says which files are generated; a folder that holds anything else belongs to somebody and is
 * refused. New files are written beside the folder and moved in its place when they are complete,
 * so that a run that is killed leaves the old files as they were.
 */
public final class OutputFolder {
    static final String LIST = ".arcomat-generated";

    private static final int NAMED_FOREIGN_FILES = 5;
    private static final String FRESH = ".arcomat-new-";
    private static final String RETIRED = ".arcomat-old-";

    private final Path folder;
    private final String shown;

    private OutputFolder(Path folder, String shown) {
        this.folder = folder;
        this.shown = shown;
    }

    /**
     * Replaces what the folder holds.
     *
     * @param shown the folder as the user wrote it
     * @param files contents by path, relative to the folder with forward slashes
     * @throws WrongUse where the folder is somebody else's, or cannot be written
     */
    public static void replace(Path folder, String shown, Map<String, byte[]> files)
            throws WrongUse {
        files.keySet().forEach(path -> requireInside(folder, path));
        Path place = Files.exists(folder) ? PathNames.real(folder) : folder.toAbsolutePath();
        try {
            new OutputFolder(place.normalize(), shown).replace(files);
        } catch (IOException e) {
            throw Failures.cannot("write to", shown, e);
        }
    }

    /** The same for texts in UTF-8; the folder is as the user wrote it. */
    public static void replaceTexts(String shown, Map<String, String> files, PathNames names)
            throws WrongUse {
        Map<String, byte[]> contents = new LinkedHashMap<>();
        files.forEach((path, text) -> contents.put(path, text.getBytes(StandardCharsets.UTF_8)));
        replace(names.resolve(shown), shown, contents);
    }

    private static void requireInside(Path folder, String path) {
        Path target = folder.resolve(path).normalize();
        if (!target.startsWith(folder.normalize()) || target.equals(folder.normalize())) {
            throw new IllegalArgumentException("'" + path + "' leaves the output folder");
        }
    }

    private void replace(Map<String, byte[]> files) throws IOException, WrongUse {
        if (Files.exists(folder) && !Files.isDirectory(folder)) {
            throw new WrongUse("'" + shown + "' is a file; --out names a folder");
        }
        Path parent = folder.getParent();
        if (parent == null) {
            throw new WrongUse("'" + shown + "' is the root of the file system");
        }
        Files.createDirectories(parent);
        clearUpAfterDeadRuns(parent);
        refuseForeignFiles();
        Path fresh = sibling(FRESH);
        try {
            delete(fresh);
            write(fresh, files);
            swap(fresh);
        } finally {
            delete(fresh);
        }
    }

    private void write(Path fresh, Map<String, byte[]> files) throws IOException {
        Files.createDirectory(fresh);
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = fresh.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
        String list = String.join("\n", new TreeSet<>(files.keySet())) + "\n";
        Files.writeString(fresh.resolve(LIST), list);
    }

    /** Two moves; a run that is killed between them is repaired by the next one. */
    private void swap(Path fresh) throws IOException {
        if (!Files.exists(folder)) {
            Files.move(fresh, folder);
            return;
        }
        if (!Files.isWritable(folder)) {
            throw new AccessDeniedException(folder.toString());
        }
        Path retired = sibling(RETIRED);
        Files.move(folder, retired);
        try {
            Files.move(fresh, folder);
        } catch (IOException e) {
            Files.move(retired, folder);
            throw e;
        }
        delete(retired);
    }

    private void refuseForeignFiles() throws IOException, WrongUse {
        if (!Files.exists(folder)) {
            return;
        }
        Set<String> foreign = filesBelow(folder);
        foreign.removeAll(listed());
        foreign.remove(LIST);
        if (foreign.isEmpty()) {
            return;
        }
        List<String> named = foreign.stream().limit(NAMED_FOREIGN_FILES).toList();
        int more = foreign.size() - named.size();
        throw new WrongUse(
                "'%s' holds files that arcomat did not generate: %s%s; name another folder with"
                        + " --out, or move them away",
                shown, String.join(", ", named), more > 0 ? " and " + more + " more" : "");
    }

    private Set<String> listed() throws IOException {
        Path list = folder.resolve(LIST);
        return Files.exists(list)
                ? new TreeSet<>(Files.readAllLines(list, StandardCharsets.UTF_8))
                : Set.of();
    }

    private static Set<String> filesBelow(Path folder) throws IOException {
        try (Stream<Path> paths = Files.walk(folder)) {
            Set<String> files = new TreeSet<>();
            paths.filter(p -> !Files.isDirectory(p, LinkOption.NOFOLLOW_LINKS))
                    .forEach(p -> files.add(folder.relativize(p).toString().replace('\\', '/')));
            return files;
        }
    }

    private Path sibling(String kind) {
        return folder.resolveSibling(
                "." + folder.getFileName() + kind + ProcessHandle.current().pid());
    }

    private void clearUpAfterDeadRuns(Path parent) throws IOException {
        String prefix = "." + folder.getFileName();
        for (Path leftover : leftovers(parent, prefix + RETIRED)) {
            if (Files.exists(folder)) {
                delete(leftover);
            } else {
                Files.move(leftover, folder);
            }
        }
        for (Path leftover : leftovers(parent, prefix + FRESH)) {
            delete(leftover);
        }
    }

    private static List<Path> leftovers(Path parent, String prefix) throws IOException {
        List<Path> found = new ArrayList<>();
        try (Stream<Path> entries = Files.list(parent)) {
            entries.filter(p -> isLeftover(p.getFileName().toString(), prefix)).forEach(found::add);
        }
        return found;
    }

    private static boolean isLeftover(String name, String prefix) {
        if (!name.startsWith(prefix) || !name.substring(prefix.length()).matches("[0-9]{1,10}")) {
            return false;
        }
        long process = Long.parseLong(name.substring(prefix.length()));
        return ProcessHandle.of(process).map(p -> !p.isAlive()).orElse(true);
    }

    /** Deletes a folder with all that is in it, if it is there. */
    public static void delete(Path folder) throws IOException {
        if (!Files.exists(folder, LinkOption.NOFOLLOW_LINKS)) {
            return;
        }
        try (Stream<Path> paths = Files.walk(folder)) {
            for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(path);
            }
        }
    }
}
