package statemachine;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What is wrong is told where it is, and each code has a page. */
class MistakesTest {
    private static final Path WRONG = Path.of("src/test/wrong");

    @Test
    void areToldWhereTheyAre() throws Exception {
        assertThat(Tool.run(WRONG, "check", "."))
                .isEqualTo(Files.readString(WRONG.resolve("expected.txt")));
    }

    @Test
    void haveAPageAndAnExampleEach() throws IOException {
        String told = Files.readString(WRONG.resolve("expected.txt"));
        for (Mistake each : Mistake.values()) {
            Path page = Path.of("src/main/resources/explain", each.code() + ".md");
            assertThat(page).content().startsWith("# " + each.code() + " ");
            if (each != Mistake.TOO_LARGE) {
                assertThat(told).contains(" error " + each.code() + ": ");
            }
        }
    }

    @Test
    void aMachineThatIsTooLargeIsRefused() throws Exception {
        Path folder = Files.createTempDirectory("large");
        StringBuilder text = new StringBuilder("component Large {\nport in Boolean go;\n");
        text.append("statemachine { initial all; state all { initial s0;\n");
        for (int i = 0; i < 101; i++) {
            text.append("state s%1$d; all -> s%1$d {go == true};\n".formatted(i));
        }
        Files.writeString(folder.resolve("Large.arc"), text + "} } }\n");
        assertThat(Tool.run(folder, "check", "."))
                .contains("Large.arc:3:1: error STM0010: ")
                .contains("more than 10000 transitions");
    }
}
