package arcomat.editor.extension;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.CampaignParser;
import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * Editors colour the words that the parsers read, all of them and no others. Who adds a keyword is
 * told here to add it to {@code editors/vscode/syntaxes} and to {@code editors/kate}.
 */
class ColouredWordsTest {
    private static final Pattern COMMENT = Pattern.compile("(?s)//[^\n]*|/\\*.*?\\*/");

    /** The rule that lists the keywords that may also be names. */
    private static final Pattern NAMES = Pattern.compile("(?s)\\nname\\s*:.*?\\n\\s*;");

    private static final Pattern KEYWORD = Pattern.compile("'([A-Za-z]\\w+)'");
    private static final Pattern IMPORT = Pattern.compile("(?m)^import ([\\w, ]+);");

    /** A word that stands in a parser's code alone in quotation marks. */
    private static final Pattern WRITTEN = Pattern.compile("\"([A-Za-z]\\w*)\"");

    /** Findings' codes, and units that are told with a number that is missing. */
    private static final Pattern NOT_READ = Pattern.compile("ARC\\d+|mm|degrees");

    /** No keyword: a constant that every stream has, and a mark in escaped letters. */
    private static final Set<String> MORE = Set.of("Tk", "u");

    private static final String WORLD = "world/src/main/java/arcomat/world/";
    private static final String CAMPAIGN = "campaign/src/main/java/arcomat/campaign/";
    private static final String SCRIPT = "lejos-runtime/sim/src/main/java/arcomat/sim/script/";

    @ParameterizedTest
    @CsvSource({
        "Expression, expression",
        "Automaton, automaton",
        "Arc, component",
        "ClassDiagram, class-diagram",
        "StreamTest, stream-test"
    })
    void keywordsOfTheGrammarsAreColoured(String grammar, String coloured) throws IOException {
        assertThat(coloured(coloured)).isEqualTo(keywords(grammar));
    }

    /** Kate has one file for all kinds of models. */
    @Test
    void keywordsOfTheGrammarsAreColouredInKate() throws IOException {
        Set<String> words = new TreeSet<>();
        for (String grammar : List.of("Arc", "ClassDiagram", "StreamTest")) {
            words.addAll(keywords(grammar));
        }
        assertThat(colouredInKate("arcomat")).isEqualTo(words);
    }

    @Test
    void wordsOfWorldsAreColoured() throws IOException {
        Set<String> words =
                written(
                        WORLD + "WorldParser",
                        WORLD + "KindDraft",
                        WORLD + "RobotDraft",
                        WORLD + "Parameters");
        assertThat(coloured("world")).isEqualTo(words);
        assertThat(colouredInKate("arcomat-world")).isEqualTo(words);
    }

    @Test
    void wordsOfScriptsAreColoured() throws IOException {
        Set<String> words = written(SCRIPT + "ScriptParser", SCRIPT + "Values");
        Stream.of(SensorName.values(), Key.values())
                .flatMap(Arrays::stream)
                .forEach(each -> words.add(each.name()));
        assertThat(coloured("script")).isEqualTo(words);
        assertThat(colouredInKate("arcomat-script")).isEqualTo(words);
    }

    @Test
    void wordsOfCampaignsAreColoured() throws IOException {
        Set<String> words = written(CAMPAIGN + "CampaignParser", CAMPAIGN + "CampaignPhrases");
        words.addAll(offered("require x below 1"));
        words.addAll(offered("worst smallest x"));
        words.addAll(offered("measure a x 1"));
        words.add("when"); // the only way to define an event
        words.addAll(keywords("Expression"));
        Set<String> coloured = coloured("campaign");
        coloured.addAll(keywords("Expression"));
        assertThat(coloured).isEqualTo(words);
        Set<String> inKate = colouredInKate("arcomat-campaign");
        inKate.addAll(keywords("Expression"));
        assertThat(inKate).isEqualTo(words);
    }

    private static Set<String> coloured(String name) {
        Set<String> words = new TreeSet<>(TextMateGrammar.named(name).words());
        words.removeAll(MORE);
        return words;
    }

    private static Set<String> colouredInKate(String name) {
        Set<String> words = new TreeSet<>(KateSyntax.named(name).words());
        words.removeAll(MORE);
        return words;
    }

    /** Those of the parser's rules in that file and in what it imports. */
    private static Set<String> keywords(String grammar) throws IOException {
        String text =
                COMMENT.matcher(Files.readString(Path.of("grammar", grammar + ".g4")))
                        .replaceAll("");
        Set<String> words = new TreeSet<>();
        KEYWORD.matcher(NAMES.matcher(text).replaceAll(""))
                .results()
                .forEach(word -> words.add(word.group(1)));
        List<String> imported =
                IMPORT.matcher(text)
                        .results()
                        .flatMap(line -> Stream.of(line.group(1).split(", ")))
                        .toList();
        for (String other : imported) {
            words.addAll(keywords(other));
        }
        return words;
    }

    private static Set<String> written(String... sources) throws IOException {
        Set<String> words = new TreeSet<>();
        for (String source : sources) {
            WRITTEN.matcher(Files.readString(Path.of(source + ".java")))
                    .results()
                    .map(word -> word.group(1))
                    .filter(word -> !NOT_READ.matcher(word).matches())
                    .forEach(words::add);
        }
        return words;
    }

    /** What the finding about a line of a campaign says that its word 'x' might have been. */
    private static List<String> offered(String line) {
        String message =
                CampaignParser.parse(new SourceFile("x.campaign", line + "\n"))
                        .findings()
                        .get(0)
                        .message();
        assertThat(message).startsWith("'x' is not ");
        return List.of(message.replaceAll(".*: ", "").split(", "));
    }
}
