package arcomat.site;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.live.Desk;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;

import org.commonmark.node.FencedCodeBlock;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;

/**
 * What opens behind each "Try it": the core of the live page is asked what it finds there. Errors
 * that belong to a page's story are those in {@code trials.txt}; {@code -Dtranscripts.update=true}
 * writes it anew. Read the difference: a name that is not there is a file that was forgotten.
 */
class TrialsTest {
    private static final Path EXPECTED = Path.of("site/src/test/resources/trials.txt");
    private static final boolean UPDATE = Boolean.getBoolean("transcripts.update");

    private static Map<Path, Manuscript> texts;
    private static Shelf shelf;

    @BeforeAll
    static void read() throws IOException {
        Repository repository = new Repository(Path.of(""), "");
        texts = Manuscript.all(repository);
        shelf = Shelf.of(repository);
    }

    @Tag("slow")
    @Test
    void opensWhatItsPageTellsOf() throws IOException {
        List<String> found = new ArrayList<>();
        texts.forEach(
                (path, text) -> {
                    Trials trials = Trials.of(text, shelf);
                    for (FencedCodeBlock block : text.all(FencedCodeBlock.class)) {
                        trials.of(block).ifPresent(trial -> found.add(path + " " + errors(trial)));
                    }
                });
        assertThat(found).hasSizeGreaterThan(200);
        List<String> wrong = found.stream().filter(each -> !each.endsWith(": ")).toList();
        if (UPDATE) {
            Files.write(EXPECTED, wrong);
        }
        assertThat(wrong).isEqualTo(Files.readAllLines(EXPECTED));
    }

    private static String errors(Trial trial) {
        List<String> paths = new ArrayList<>();
        List<String> contents = new ArrayList<>();
        for (List<Trial.Text> each : List.of(trial.files(), trial.needed())) {
            each.forEach(text -> paths.add(text.path()));
            each.forEach(text -> contents.add(text.text()));
        }
        String answer =
                new Desk()
                        .check(
                                paths.toArray(String[]::new),
                                contents.toArray(String[]::new),
                                trial.needed().stream()
                                        .map(Trial.Text::path)
                                        .toArray(String[]::new));
        TreeSet<String> codes = new TreeSet<>();
        for (JsonNode finding : json(answer).get("findings")) {
            if (finding.get("severity").asText().equals("error")) {
                codes.add(finding.get("code").asText());
            }
        }
        return trial.files().get(trial.open()).path() + ": " + String.join(" ", codes);
    }

    private static JsonNode json(String text) {
        try {
            return new ObjectMapper().readTree(text);
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /**
     * All but what has changed in some, and what defines nothing, as the page about ARC0005 shows.
     */
    @Test
    void everyModelCanBeTried() {
        List<String> without = new ArrayList<>();
        texts.forEach(
                (path, text) -> {
                    Trials trials = Trials.of(text, shelf);
                    for (FencedCodeBlock block : text.all(FencedCodeBlock.class)) {
                        Fenced fenced = Fenced.of(block);
                        if (fenced.isModel() && !fenced.isPart() && trials.of(block).isEmpty()) {
                            without.add(path + " " + fenced.caption());
                        }
                    }
                });
        without.removeIf(each -> each.startsWith(Trials.CHANGES + " "));
        assertThat(without).containsExactly("src/main/resources/explain/ARC0005.md arc");
    }

    @Test
    void anAddressSaysTheWholeState() throws IOException {
        Manuscript tutorial = texts.get(Path.of("docs/tutorial.md"));
        Trials trials = Trials.of(tutorial, shelf);
        Trial robot =
                tutorial.all(FencedCodeBlock.class).stream()
                        .filter(block -> block.getInfo().endsWith("mower/Robot.arc"))
                        .flatMap(block -> trials.of(block).stream())
                        .findFirst()
                        .orElseThrow();
        byte[] packed = Base64.getUrlDecoder().decode(robot.packed());
        String plain =
                new String(
                        new InflaterInputStream(
                                        new ByteArrayInputStream(packed), new Inflater(true))
                                .readAllBytes(),
                        StandardCharsets.UTF_8);
        JsonNode state = json(plain);
        assertThat(state.get("component").asText()).isEqualTo("mower.Robot");
        assertThat(state.get("view").asText()).isEqualTo("see");
        assertThat(state.get("files").get(state.get("open").asInt()).get("path").asText())
                .isEqualTo("src/main/arc/mower/Robot.arc");
        assertThat(state.get("files").findValuesAsText("path"))
                .contains("src/main/arc/mower/Pilot.arc", "src/test/arc/mower/PilotTest.mt")
                .doesNotHaveDuplicates();
        assertThat(state.get("needed").findValuesAsText("path"))
                .anyMatch(path -> path.endsWith("nxt/DifferentialDrive.arc"))
                .noneMatch(path -> path.contains("coffee"));
    }
}
