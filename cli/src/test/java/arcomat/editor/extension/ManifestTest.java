package arcomat.editor.extension;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Embedded;
import arcomat.editor.server.EditorServer;
import arcomat.editor.verdict.VerdictLenses;
import arcomat.guest.host.Guests;
import arcomat.pipeline.file.FileFinder;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.InitializeParams;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** What the extension for VS Code says of itself, against what it is; without Node. */
class ManifestTest {
    private static final Path FOLDER = Path.of("editors/vscode");
    private static final Pattern REGISTERED =
            Pattern.compile("(?:register|registerCommand)\\('(arcomat\\.\\w+)'");
    private static final Pattern MENTIONED = Pattern.compile("\\(command:(arcomat\\.\\w+)");
    private static final Pattern READING =
            Pattern.compile("const READING = new Set\\(\\[([^\\]]*)");
    private static final Pattern WORD = Pattern.compile("'([\\w-]+)'");

    /** The first word of a command line. */
    private static final Pattern CALLED = Pattern.compile("\\['([a-z-]+)', (?:'|\\w|\\.\\.\\.)");

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
        Set<String> there = all(REGISTERED, code());
        there.addAll(ofServer());
        assertThat(there).isEqualTo(commands());
        assertThat(commands()).containsAll(contributes.get("menus").findValuesAsText("command"));
        assertThat(commands())
                .containsAll(all(MENTIONED, contributes.get("walkthroughs").toString()));
    }

    /** The client registers what the server says that it does. */
    private static List<String> ofServer() {
        InitializeParams params = new InitializeParams();
        params.setCapabilities(new ClientCapabilities());
        return new EditorServer("0", Guests.NONE, List.of())
                .initialize(params)
                .join()
                .getCapabilities()
                .getExecuteCommandProvider()
                .getCommands();
    }

    @Test
    void whatALensOffersIsThere() {
        assertThat(ofServer())
                .containsExactlyInAnyOrder(VerdictLenses.SHOW, VerdictLenses.RUN)
                .allSatisfy(each -> assertThat(commands()).contains(each));
    }

    /** What needs words that only a lens has is offered nowhere else. */
    @Test
    void thePaletteHidesWhatALensOffers() {
        List<String> hidden = new ArrayList<>();
        for (JsonNode each : contributes.get("menus").get("commandPalette")) {
            if (each.get("when").textValue().equals("false")) {
                hidden.add(each.get("command").textValue());
            }
        }
        assertThat(hidden).containsExactlyInAnyOrderElementsOf(ofServer());
    }

    /** Those of the tool that know models of others are told of them. */
    @Test
    void commandsAreToldOfLibraries() throws Exception {
        Matcher reading = READING.matcher(code());
        assertThat(reading.find()).isTrue();
        Set<String> commands = new TreeSet<>();
        WORD.matcher(reading.group(1)).results().forEach(each -> commands.add(each.group(1)));
        for (String each : commands) {
            assertThat(help(each)).as(each).contains("--library=DIR");
        }
        assertThat(help("explain")).doesNotContain("--library");
        assertThat(all(CALLED, code()))
                .allSatisfy(
                        each ->
                                assertThat(help(each).contains("--library=DIR"))
                                        .as(each)
                                        .isEqualTo(commands.contains(each)));
    }

    private static String help(String command) {
        StringWriter out = new StringWriter();
        try {
            Embedded.run(
                    FOLDER.toAbsolutePath(),
                    new PrintWriter(out),
                    new PrintWriter(Writer.nullWriter()),
                    command,
                    "--help");
        } catch (InterruptedException e) {
            throw new AssertionError(e);
        }
        return out.toString();
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
