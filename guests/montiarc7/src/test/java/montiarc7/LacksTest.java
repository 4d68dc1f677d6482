package montiarc7;

import static org.assertj.core.api.Assertions.assertThat;

import montiarc7.source.Lack;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** What cannot be converted is told once for each file, where it is, and each code has a page. */
class LacksTest {
    private static final Path TESTS = Path.of("src/test");

    @TempDir private Path folder;

    @Test
    void areToldWhereTheyAre() throws Exception {
        String out = folder.resolve("out").toString();
        assertThat(
                        Tool.run(TESTS, "import", "montiarc7", "wrong", "--out", out)
                                .replace(out, "OUT"))
                .isEqualTo(Files.readString(TESTS.resolve("wrong/expected.txt")));
    }

    @Test
    void haveAPageAndAnExampleEach() throws IOException {
        String told =
                Files.readString(TESTS.resolve("wrong/expected.txt"))
                        + Files.readString(TESTS.resolve("told.txt"));
        for (Lack each : Lack.values()) {
            assertThat(Path.of("src/main/resources/explain", each.code() + ".md"))
                    .content()
                    .startsWith("# " + each.code() + " ");
            assertThat(told).contains(" " + each.code() + ": ");
        }
    }
}
