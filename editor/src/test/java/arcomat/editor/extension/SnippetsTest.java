package arcomat.editor.extension;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.CampaignParser;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.check.CheckFiles;
import arcomat.sim.script.ScriptParser;
import arcomat.source.SourceFile;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** What the extension offers to be filled in is right before anybody has filled in anything. */
class SnippetsTest {
    private static final Path FOLDER = Path.of("editors/vscode/snippets");

    /** What stands around those that are no whole files. */
    private static final Map<String, String> AROUND =
            Map.ofEntries(
                    Map.entry(
                            "table",
                            """
                            package p;
                            component Gate {
                                port in Boolean pressed, out Boolean opens;
                            %s}
                            """),
                    Map.entry("enum", "package p;\nclassdiagram Colours {\n%s}\n"),
                    Map.entry("class", "package p;\nclassdiagram Papers {\n%s}\n"),
                    Map.entry("kind", "floor 900 900\n%srobot one rover at 300 500\n"),
                    Map.entry(
                            "parameter",
                            """
                            %s
                            floor 900 900
                            noise light $light
                            kind rover
                              program jar a.jar
                            robot one rover at 300 500
                            """),
                    Map.entry("require", "world a.world\nsample random 1\n%s"),
                    Map.entry("measure", "world a.world\nsample random 1\n%s"),
                    Map.entry("split", "world a.world\nsample random 1\n%s"));

    @TempDir private Path folder;

    private static String whole(Snippet snippet) {
        return AROUND.getOrDefault(snippet.prefix(), "%s").formatted(snippet.text());
    }

    private static List<Snippet> of(String kind) throws IOException {
        List<Snippet> snippets = Snippet.of(FOLDER.resolve(kind + ".json"));
        assertThat(snippets).isNotEmpty();
        return snippets;
    }

    /** All of them together are one model, ready to run. */
    @Test
    void modelsHaveNoFindings() throws Exception {
        write("component", "component", ".arc");
        write("automaton", "automaton", ".ioautomaton");
        write("class-diagram", "classdiagram", ".cd");
        write("stream-test", "testsuite", ".mt");
        var checked =
                Session.in(folder, Progress.NONE)
                        .run(new CheckFiles(List.of(folder.toString()), true));
        assertThat(checked.findings()).isEmpty();
    }

    private void write(String kind, String keyword, String ending) throws IOException {
        Files.createDirectories(folder.resolve("p"));
        for (Snippet snippet : of(kind)) {
            String text = whole(snippet);
            String name = text.replaceAll("(?s).*?\\b" + keyword + " (\\w+).*", "$1");
            Path file = folder.resolve("p").resolve(name + ending);
            assertThat(file).doesNotExist();
            Files.writeString(file, text);
        }
    }

    @Test
    void worldsAreRead() throws IOException {
        for (Snippet snippet : of("world")) {
            SourceFile file = new SourceFile("a.world", whole(snippet));
            assertThat(WorldParser.parse(file).findings()).as(snippet.prefix()).isEmpty();
        }
    }

    @Test
    void campaignsAreRead() throws IOException {
        for (Snippet snippet : of("campaign")) {
            SourceFile file = new SourceFile("a.campaign", whole(snippet));
            assertThat(CampaignParser.parse(file).findings()).as(snippet.prefix()).isEmpty();
        }
    }

    @Test
    void scriptsAreRead() throws IOException {
        for (Snippet snippet : of("script")) {
            assertThat(ScriptParser.parse(whole(snippet)).errors()).as(snippet.prefix()).isEmpty();
        }
    }
}
