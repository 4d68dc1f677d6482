package arcomat.editor.extension;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.file.FileFinder;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What the extension for VS Code says of itself, against what it is; without Node. */
class ManifestTest {
    private static final Path FOLDER = Path.of("editors/vscode");
    private static final Pattern REGISTERED =
            Pattern.compile("(?:register|registerCommand)\\('(arcomat\\.\\w+)'");
    private static final Pattern MENTIONED = Pattern.compile("\\(command:(arcomat\\.\\w+)");
    private static final Pattern PATH = Pattern.compile("\"(?:\\./|media/)[^\"]+\"");

    private static JsonNode manifest;
    private static JsonNode contributes;

    @BeforeAll
    static void read() throws IOException {
        manifest = new ObjectMapper().readTree(FOLDER.resolve("package.json").toFile());
        contributes = manifest.get("contributes");
    }

    private static String code() throws IOException {
        StringBuilder code = new StringBuilder();
        try (Stream<Path> files = Files.list(FOLDER.resolve("src"))) {
            for (Path file : files.toList()) {
                code.append(Files.readString(file));
            }
        }
        return code.toString();
    }

    private static Set<String> all(Pattern pattern, String text) {
        Set<String> found = new TreeSet<>();
        pattern.matcher(text).results().forEach(each -> found.add(each.group(1)));
        return found;
    }

    private static Set<String> commands() {
        return new TreeSet<>(contributes.get("commands").findValuesAsText("command"));
    }

    @Test
    void everyCommandIsThere() throws IOException {
        assertThat(all(REGISTERED, code())).isEqualTo(commands());
        assertThat(commands()).containsAll(contributes.get("menus").findValuesAsText("command"));
        assertThat(commands())
                .containsAll(all(MENTIONED, contributes.get("walkthroughs").toString()));
    }

    @Test
    void everyFileIsThere() {
        List<String> missing = new ArrayList<>();
        PATH.matcher(contributes.toString())
                .results()
                .map(path -> path.group().replace("\"", ""))
                .filter(path -> !Files.exists(FOLDER.resolve(path)))
                .forEach(missing::add);
        assertThat(missing).isEmpty();
    }

    /** Each language has an end of file names, colours, and the id by which the code knows it. */
    @Test
    void languagesAreThoseOfTheTool() throws IOException {
        String code = code();
        Set<String> models = new TreeSet<>();
        for (JsonNode language : contributes.get("languages")) {
            String id = language.get("id").textValue();
            String ending = language.get("extensions").get(0).textValue();
            assertThat(code).contains("'" + ending + "': '" + id + "'");
            assertThat(contributes.get("grammars").findValuesAsText("language")).contains(id);
            if (FileFinder.isModelFile(Path.of("a" + ending))) {
                models.add(ending);
            }
        }
        assertThat(models).containsExactly(".arc", ".cd", ".ioautomaton", ".mt");
        assertThat(contributes.get("languages").findValuesAsText("id")).hasSize(7);
    }

    /** What is installed is what was tried: no version is a range, and no file names a registry. */
    @Test
    void whatItNeedsIsPinned() throws IOException {
        for (String kind : List.of("dependencies", "devDependencies")) {
            manifest.get(kind).forEach(each -> assertThat(each.textValue()).matches("[\\d.]+"));
        }
        JsonNode lock = new ObjectMapper().readTree(FOLDER.resolve("package-lock.json").toFile());
        assertThat(lock.findValuesAsText("resolved")).isEmpty();
        JsonNode packages = lock.get("packages");
        for (JsonNode each : packages) {
            assertThat(each.has("integrity")).isEqualTo(each != packages.get(""));
        }
    }
}
