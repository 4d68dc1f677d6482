package arcomat.laws;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * What {@code docs/semantics.md} says is what the tool does, sentence by sentence. In the files of
 * {@code src/test/resources/meaning} lines {@code // > TEXT} are a sentence of the page; the {@link
 * Cases} behind it show that it is so. Each sentence stands on the page, and each sentence of the
 * sections in {@link #SHOWN} is in a file.
 */
class MeaningTest {
    private static final Path FOLDER = Path.of("verify/src/test/resources/meaning");
    private static final Path PAGE = Path.of("docs/semantics.md");

    private static final List<String> SHOWN =
            List.of(
                    "When a transition is enabled",
                    "Undefined, and wrong",
                    "Numbers and objects",
                    "One step",
                    "Several automata",
                    "Runs");

    @TestFactory
    Stream<DynamicTest> eachSentenceIsSo() throws IOException {
        List<DynamicTest> tests = new ArrayList<>();
        for (Path file : files()) {
            Cases cases = Cases.read(file);
            sentences(cases)
                    .forEach(
                            (sentence, lines) ->
                                    lines.forEach(
                                            line ->
                                                    tests.add(
                                                            DynamicTest.dynamicTest(
                                                                    sentence + " " + line,
                                                                    () -> cases.check(line)))));
        }
        return tests.stream();
    }

    @Test
    void eachSentenceThatIsShownStandsOnThePage() throws IOException {
        Set<String> written = Sentences.of(Files.readString(PAGE), any -> true);
        assertThat(written).containsAll(shown());
    }

    @Test
    void eachSentenceOfTheSectionsIsShown() throws IOException {
        String page = Files.readString(PAGE);
        assertThat(shown()).containsAll(Sentences.of(page, SHOWN::contains));
        assertThat(SHOWN).allMatch(each -> !Sentences.of(page, each::equals).isEmpty());
    }

    private static Set<String> shown() throws IOException {
        Set<String> shown = new LinkedHashSet<>();
        for (Path file : files()) {
            Map<String, List<String>> sentences = sentences(Cases.read(file));
            assertThat(sentences).as(file.toString()).isNotEmpty();
            sentences.forEach((each, cases) -> assertThat(cases).as(each).isNotEmpty());
            shown.addAll(sentences.keySet());
        }
        return shown;
    }

    private static List<Path> files() throws IOException {
        try (Stream<Path> files = Files.list(FOLDER)) {
            return files.sorted().toList();
        }
    }

    /** Each sentence with its cases. */
    private static Map<String, List<String>> sentences(Cases cases) {
        Map<String, List<String>> sentences = new LinkedHashMap<>();
        StringBuilder sentence = new StringBuilder();
        for (String line : cases.head()) {
            if (line.startsWith("> ")) {
                sentence.append(sentence.isEmpty() ? "" : " ").append(line.substring(2));
            } else if (!sentence.isEmpty()) {
                sentences.put(sentence.toString(), new ArrayList<>());
                sentence.setLength(0);
            }
            if (Cases.isCase(line)) {
                sentences.values().stream().reduce((a, b) -> b).orElseThrow().add(line);
            }
        }
        return sentences;
    }
}
