package arcomat.lower;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * I/O tables are a behaviour language of the tool's own, written against the door that guests come
 * by. They show what a further one costs: a room of its own and a line in a list. What is behind
 * the syntax does not know that there are tables.
 */
class BehaviourLanguageTest {
    private static final Path MAIN = Path.of("src/main/java/arcomat");
    private static final Path EDITOR = Path.of("editor/src/main/java/arcomat/editor");

    @Test
    void theGrammarIsAFileOfItsOwnAndOneAlternative() {
        assertThat(lines(Path.of("grammar/Arc.g4")).filter(l -> l.toLowerCase().contains("table")))
                .as("the import and the alternative")
                .hasSizeLessThanOrEqualTo(2)
                .isNotEmpty();
        assertThat(mentions(Path.of("grammar")))
                .containsExactlyInAnyOrder("grammar/Arc.g4", "grammar/IoTable.g4");
    }

    @Test
    void itIsWrittenAgainstTheDoorAlone() {
        assertThat(sources(MAIN.resolve("table")))
                .isNotEmpty()
                .allSatisfy(
                        file ->
                                assertThat(lines(file))
                                        .filteredOn(line -> line.startsWith("import arcomat."))
                                        .allMatch(
                                                line ->
                                                        line.matches(
                                                                "import"
                                                                    + " arcomat\\.(guest|source)\\..*")));
    }

    @Test
    void oneListNamesIt() {
        assertThat(sources(MAIN))
                .filteredOn(file -> !file.startsWith(MAIN.resolve("table")))
                .filteredOn(file -> lines(file).anyMatch(line -> line.contains("arcomat.table")))
                .containsExactly(MAIN.resolve("translate/HouseLanguages.java"));
    }

    /**
     * What stands beside the texts: how tables are set, and where one goes on after a mistake; its
     * codes, and what completion offers where the grammar names its columns.
     */
    @Test
    void besidesTheSyntaxTwoPlacesKnowHowItLooks() {
        assertThat(Stream.concat(sources(MAIN).stream(), sources(EDITOR).stream()))
                .filteredOn(file -> !file.startsWith(MAIN.resolve("table")))
                .filteredOn(file -> lines(file).anyMatch(BehaviourLanguageTest::namesTables))
                .filteredOn(file -> !file.startsWith(MAIN.resolve("syntax")))
                .containsExactlyInAnyOrder(
                        MAIN.resolve("check/language/LanguageLaws.java"),
                        EDITOR.resolve("answer/completion/KnownNames.java"));
    }

    @Test
    void thePageForNewcomersNamesEachPlace() throws IOException {
        String page = Files.readString(Path.of("docs/extend.md"));
        String section = page.substring(page.indexOf("\n## A behaviour language\n"));
        assertThat(mentions(MAIN.resolve("syntax")))
                .map(file -> file.replaceFirst(".*/(\\w+)\\.java", "$1"))
                .isNotEmpty()
                .allSatisfy(name -> assertThat(section).contains("`" + name + "`"));
        assertThat(section)
                .contains("`HouseLanguages`", "`LanguageLaws`", "`KnownNames`", "`arcomat.table`");
    }

    /** The files below a folder whose code names the table, comments aside. */
    private static List<String> mentions(Path folder) {
        return sources(folder).stream()
                .filter(file -> lines(file).anyMatch(BehaviourLanguageTest::namesTables))
                .map(file -> file.toString().replace('\\', '/'))
                .toList();
    }

    private static List<Path> sources(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean namesTables(String line) {
        return line.matches(".*(?i:io_?table|table(row|symbol|lowering|cell|inputs|outputs)).*");
    }

    private static Stream<String> lines(Path file) {
        try {
            return Files.readString(file).lines();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
