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
 * I/O tables are the second behaviour language. They show what a further one costs: a grammar with
 * one alternative in the grammar of components, a tree node, a builder and printer for it, symbols,
 * checks and a lowering. What comes behind the model does not know that there are tables.
 */
class BehaviourLanguageTest {
    private static final Path MAIN = Path.of("src/main/java/arcomat");

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
    void theTreeHasOneNodeForIt() {
        assertThat(mentions(MAIN.resolve("tree")))
                .containsExactlyInAnyOrder(
                        "src/main/java/arcomat/tree/IoTable.java",
                        "src/main/java/arcomat/tree/Behaviour.java");
    }

    @Test
    void oneClassLowersIt() {
        assertThat(mentions(MAIN.resolve("lower")))
                .containsExactlyInAnyOrder(
                        "src/main/java/arcomat/lower/TableLowering.java",
                        "src/main/java/arcomat/lower/ComponentLowering.java");
    }

    /** A list of laws names each of them, and is no place to think about. */
    @Test
    void thePageForNewcomersNamesEachPlace() throws IOException {
        String page = Files.readString(Path.of("docs/extend.md"));
        String section = page.substring(page.indexOf("\n## A behaviour language\n"));
        assertThat(Stream.of("tree", "syntax", "symbols", "check", "lower"))
                .flatMap(room -> mentions(MAIN.resolve(room)))
                .map(file -> file.replaceFirst(".*/(\\w+)\\.java", "$1"))
                .filteredOn(name -> !name.endsWith("Laws"))
                .isNotEmpty()
                .allSatisfy(name -> assertThat(section).contains("`" + name + "`"));
    }

    @Test
    void nothingBehindTheModelKnowsIt() {
        for (String room : List.of("model", "semantics", "simulate", "generate", "report")) {
            Path folder = MAIN.resolve(room);
            assertThat(Files.exists(folder) ? mentions(folder) : List.of()).as(room).isEmpty();
        }
    }

    /** The files below a folder whose code names the table, comments aside. */
    private static List<String> mentions(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.filter(Files::isRegularFile)
                    .filter(file -> lines(file).anyMatch(BehaviourLanguageTest::namesTables))
                    .map(file -> file.toString().replace('\\', '/'))
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static boolean namesTables(String line) {
        return line.matches(".*(?i:io_?table|table(row|symbol|lowering|cell)).*");
    }

    private static Stream<String> lines(Path file) {
        try {
            return Files.readString(file).lines();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
