package arcomat.maven;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/**
 * A folder that holds what it has to hold, and nothing else. Files that are right already are left
 * alone: whoever looks at their times, as compilers do, has nothing to do.
 */
record MirroredFolder(Path folder) {

    /** Files below a folder, by their paths from there. */
    static Map<String, byte[]> contents(Path folder) throws IOException {
        Map<String, byte[]> contents = new TreeMap<>();
        for (Path file : files(folder)) {
            String path = folder.relativize(file).toString().replace('\\', '/');
            contents.put(path, Files.readAllBytes(file));
        }
        return contents;
    }

    /** Writes what differs, and removes what does not belong there. */
    void hold(Map<String, byte[]> contents) throws IOException {
        for (Map.Entry<String, byte[]> each : contents.entrySet()) {
            Path file = folder.resolve(each.getKey());
            if (!Files.isRegularFile(file)
                    || !Arrays.equals(Files.readAllBytes(file), each.getValue())) {
                Files.createDirectories(file.getParent());
                Files.write(file, each.getValue());
            }
        }
        if (Files.isDirectory(folder)) {
            removeOthers(contents);
        }
    }

    private void removeOthers(Map<String, byte[]> contents) throws IOException {
        for (Path file : files(folder)) {
            String path = folder.relativize(file).toString().replace('\\', '/');
            if (!contents.containsKey(path)) {
                Files.delete(file);
            }
        }
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                if (Files.isDirectory(each) && isEmpty(each)) {
                    Files.delete(each);
                }
            }
        }
    }

    private static boolean isEmpty(Path folder) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.findAny().isEmpty();
        }
    }

    private static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> all = Files.walk(folder)) {
            return all.filter(Files::isRegularFile).sorted().toList();
        }
    }
}
