package arcomat.fuzz.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A folder to run in, with a folder for temporary files beside it.
 *
 * @param base above both
 */
record Sandbox(Path base) {
    Path folder() {
        return base.resolve("box");
    }

    Path temporary() {
        return base.resolve("tmp");
    }

    /** Holds these files and no others. */
    void fill(Map<String, byte[]> files) throws IOException {
        clear();
        Files.createDirectories(folder());
        Files.createDirectories(temporary());
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Path path = folder().resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.write(path, file.getValue());
        }
    }

    /** All there is, temporary files included, by the path from the folder. */
    SortedMap<String, byte[]> content() throws IOException {
        SortedMap<String, byte[]> content = new TreeMap<>();
        try (Stream<Path> paths = Files.walk(base)) {
            for (Path path : (Iterable<Path>) paths::iterator) {
                if (Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
                    String name = folder().relativize(path).toString().replace('\\', '/');
                    content.put(name, Files.readAllBytes(path));
                }
            }
        }
        return content;
    }

    void clear() throws IOException {
        if (Files.exists(base)) {
            try (Stream<Path> paths = Files.walk(base)) {
                for (Path path : paths.sorted(Comparator.reverseOrder()).toList()) {
                    Files.delete(path);
                }
            }
        }
    }
}
