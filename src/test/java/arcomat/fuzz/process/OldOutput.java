package arcomat.fuzz.process;

import java.nio.charset.StandardCharsets;
import java.util.SortedMap;
import java.util.stream.Collectors;

/** A folder that an earlier run has written: it stays, or another takes its place as a whole. */
final class OldOutput {
    static final String FOLDER = "out";
    private static final String LIST = FOLDER + "/.arcomat-generated";
    private static final String OLD = FOLDER + "/Old.java";

    private OldOutput() {}

    static void addTo(SortedMap<String, byte[]> files) {
        files.put(LIST, "Old.java\n".getBytes(StandardCharsets.UTF_8));
        files.put(OLD, "class Old {}\n".getBytes(StandardCharsets.UTF_8));
    }

    /** Whether the files of the folder are those that its list names, so that none is missing. */
    static boolean isWhole(SortedMap<String, byte[]> content) {
        if (!content.containsKey(LIST)) {
            return content.keySet().stream().noneMatch(OldOutput::isInside);
        }
        String listed =
                new String(content.get(LIST), StandardCharsets.UTF_8)
                        .lines()
                        .sorted()
                        .collect(Collectors.joining("\n"));
        String there =
                content.keySet().stream()
                        .filter(path -> isInside(path) && !path.equals(LIST))
                        .map(path -> path.substring(FOLDER.length() + 1))
                        .sorted()
                        .collect(Collectors.joining("\n"));
        return listed.equals(there);
    }

    private static boolean isInside(String path) {
        return path.startsWith(FOLDER + "/");
    }
}
