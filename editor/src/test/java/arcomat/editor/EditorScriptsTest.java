package arcomat.editor;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.editor.foreign.SignFiles;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * Plays every script of {@code src/test/resources/editor}: files, each behind a line {@code ---
 * PATH}, then steps behind {@code ===}, each with what is shown. With {@code
 * -Dtranscripts.update=true} the files are rewritten to what is shown now; read the difference
 * before keeping it.
 */
class EditorScriptsTest {
    private static final Path FOLDER = Path.of("editor/src/test/resources/editor");
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");
    private static final String FILE = "--- ";
    private static final String STEP = "=== ";

    @TempDir private Path temporary;

    @Tag("some-slow")
    @TestFactory
    Stream<DynamicTest> scripts() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList().stream()
                    .map(f -> DynamicTest.dynamicTest(f.getFileName().toString(), () -> play(f)));
        }
    }

    private void play(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        Path folder = Files.createDirectory(temporary.resolve(file.getFileName()));
        String played = play(lines, folder.toRealPath());
        if (UPDATE) {
            Files.writeString(file, played);
        }
        assertThat(played).isEqualTo(String.join("\n", lines) + "\n");
    }

    private static String play(List<String> lines, Path folder) throws IOException {
        StringBuilder played = new StringBuilder();
        int at = 0;
        while (!lines.get(at).startsWith(STEP)) {
            String line = lines.get(at++);
            played.append(line).append('\n');
            if (line.startsWith(FILE)) {
                StringBuilder text = new StringBuilder();
                while (!isHeading(lines.get(at))) {
                    text.append(lines.get(at)).append('\n');
                    played.append(lines.get(at++)).append('\n');
                }
                Path path = folder.resolve(line.substring(FILE.length()));
                Files.createDirectories(Objects.requireNonNull(path.getParent()));
                Files.writeString(path, text);
            }
        }
        try (EditorClient client = new EditorClient(folder, SignFiles.GUESTS)) {
            EditorScript script = new EditorScript(client);
            for (String line : lines.subList(at, lines.size())) {
                if (line.startsWith(STEP)) {
                    played.append(line).append('\n');
                    played.append(script.run(line.substring(STEP.length())));
                }
            }
        }
        return played.toString();
    }

    private static boolean isHeading(String line) {
        return line.startsWith(FILE) || line.startsWith(STEP);
    }
}
