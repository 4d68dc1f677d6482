package arcomat.agent;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;

/**
 * Plays every script of {@code src/test/resources/agent}: files, each behind a line {@code ---
 * PATH}, or links, {@code --- PATH -> TARGET}, then steps behind {@code ===}, each with what the
 * server answers. The model root is the folder {@code models}. {@code send LINE} shows the line
 * that comes back, {@code tell LINE} waits for none, {@code call TOOL ARGUMENTS} shows the texts of
 * the result, {@code findings TOOL ARGUMENTS} only what they say. With {@code
 * -Dtranscripts.update=true} the files are rewritten to what is shown now; read the difference
 * before keeping it.
 */
class AgentScriptsTest {
    private static final Path FOLDER = Path.of("agent/src/test/resources/agent");
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");
    private static final String FILE = "--- ";
    private static final String STEP = "=== ";
    private static final int SECONDS = 30;
    private static final int LONGEST = 2500;

    @TempDir private Path temporary;

    @TestFactory
    Stream<DynamicTest> scripts() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.filter(file -> file.toString().endsWith(".txt")).sorted().toList().stream()
                    .map(f -> DynamicTest.dynamicTest(f.getFileName().toString(), () -> play(f)));
        }
    }

    private void play(Path file) throws IOException {
        List<String> lines = Files.readAllLines(file);
        Path folder = Files.createDirectory(temporary.resolve(file.getFileName()));
        String played = play(lines, folder);
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
                place(line.substring(FILE.length()), text.toString(), folder);
            }
        }
        try (AgentClient client = new AgentClient(folder, List.of("models"), SECONDS, LONGEST)) {
            for (String line : lines.subList(at, lines.size())) {
                if (line.startsWith(STEP)) {
                    played.append(line).append('\n');
                    played.append(run(line.substring(STEP.length()), client));
                }
            }
        }
        return played.toString();
    }

    private static void place(String name, String text, Path folder) throws IOException {
        String[] link = name.split(" -> ");
        Path path = folder.resolve(link[0]);
        Files.createDirectories(Objects.requireNonNull(path.getParent()));
        if (link.length == 2) {
            Files.createSymbolicLink(path, Path.of(link[1]));
        } else {
            Files.writeString(path, text);
        }
    }

    private static String run(String step, AgentClient client) throws IOException {
        String[] words = step.split(" ", 2);
        switch (words[0]) {
            case "send" -> {
                client.send(words[1]);
                return client.receive() + "\n";
            }
            case "tell" -> {
                client.send(words[1]);
                return "";
            }
            case "call" -> {
                String[] call = words[1].split(" ", 2);
                return shown(client.call(call[0], call.length == 2 ? call[1] : "{}"));
            }
            case "findings" -> {
                String[] call = words[1].split(" ", 2);
                return messages(client.call(call[0], call.length == 2 ? call[1] : "{}"));
            }
            default -> throw new AssertionError("no step: " + step);
        }
    }

    private static String shown(JsonNode result) {
        StringBuilder shown =
                new StringBuilder(result.get("isError").asBoolean() ? "failed: " : "");
        for (JsonNode each : result.get("content")) {
            String text = each.get("text").asText();
            shown.append(text).append(text.endsWith("\n") ? "" : "\n");
        }
        return shown.toString();
    }

    private static String messages(JsonNode result) throws IOException {
        if (result.get("isError").asBoolean()) {
            return shown(result);
        }
        StringBuilder messages = new StringBuilder();
        String text = result.get("content").get(0).get("text").asText();
        for (JsonNode each : new ObjectMapper().readTree(text).get("findings")) {
            messages.append(each.get("file").asText()).append(": ");
            messages.append(each.get("message").asText()).append('\n');
        }
        return messages.toString();
    }

    private static boolean isHeading(String line) {
        return line.startsWith(FILE) || line.startsWith(STEP);
    }
}
