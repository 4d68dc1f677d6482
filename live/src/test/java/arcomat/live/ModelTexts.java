package arcomat.live;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** Texts of this repository, as the page has them. */
final class ModelTexts {
    private static final Path LIBRARY = Path.of("../lejos-runtime/nxt/src/main/arc");
    private static final List<String> ENDINGS = List.of(".arc", ".cd", ".mt", ".world");

    private ModelTexts() {}

    /** The model library, by paths below its root. */
    static Map<String, String> library() throws IOException {
        return below(LIBRARY);
    }

    /** Models and worlds of a folder, by paths below it. */
    static Map<String, String> below(Path root) throws IOException {
        Map<String, String> texts = new TreeMap<>();
        for (Path file : files(root)) {
            texts.put(root.relativize(file).toString(), Files.readString(file));
        }
        return texts;
    }

    /** With the library. */
    static Map<String, String> runnable(Path root) throws IOException {
        Map<String, String> texts = library();
        texts.putAll(below(root));
        return texts;
    }

    /** Lays texts on a desk of this machine. */
    static String check(Desk desk, Map<String, String> texts) {
        return desk.check(
                texts.keySet().toArray(new String[0]),
                texts.values().toArray(new String[0]),
                new String[0]);
    }

    private static List<Path> files(Path root) throws IOException {
        try (Stream<Path> all = Files.walk(root)) {
            return all.filter(file -> ENDINGS.stream().anyMatch(file.toString()::endsWith))
                    .sorted()
                    .toList();
        }
    }
}
