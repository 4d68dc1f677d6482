package arcomat.fuzz.process;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.SortedMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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

    /** The list of what is generated says something else. */
    static void damage(SortedMap<String, byte[]> files, ByteDamage damage) {
        files.put(LIST, damage.apply(files.get(LIST)));
    }

    /** Whether a folder is what it was. */
    static boolean isSame(SortedMap<String, byte[]> before, SortedMap<String, byte[]> after) {
        return Stream.of(before, after)
                .flatMap(content -> content.keySet().stream())
                .filter(OldOutput::isInside)
                .allMatch(path -> Arrays.equals(before.get(path), after.get(path)));
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
