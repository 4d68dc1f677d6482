package arcomat.benchmarks.measure;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The committed results of a group, one line per benchmark: label, median, unit. */
public final class Baseline {
    private static final Path FOLDER = Path.of("benchmarks", "baseline");

    private Baseline() {}

    public static void write(Group group, Map<String, Measurement> results, List<String> notes)
            throws IOException {
        List<String> lines = new ArrayList<>();
        lines.add(
                "# ./gradlew :benchmarks:measure -Pgroups="
                        + group.name()
                        + ", "
                        + machine()
                        + "; label, median, unit");
        for (Measurement result : results.values()) {
            lines.add(
                    String.format(
                            Locale.ROOT,
                            "%s\t%.3f\t%s",
                            result.label(),
                            result.median(),
                            result.unit()));
        }
        notes.forEach(note -> lines.add("# " + note));
        Files.createDirectories(FOLDER);
        Files.writeString(FOLDER.resolve(group.name() + ".tsv"), String.join("\n", lines) + "\n");
    }

    private static String machine() {
        return "Java "
                + System.getProperty("java.version")
                + ", "
                + Runtime.getRuntime().availableProcessors()
                + " processors";
    }
}
