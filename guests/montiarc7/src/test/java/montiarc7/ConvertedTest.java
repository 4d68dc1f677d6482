package montiarc7;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;

/** What is written is known, and check has nothing to say against it. */
class ConvertedTest {
    private static final Path MODELS = Path.of("src/test");

    @TempDir private Path folder;

    @Test
    void modelsAreWrittenAsTheyAreKnown() throws Exception {
        Path out = folder.resolve("converted");
        String told = Tool.run(MODELS, "import", "montiarc7", "original", "--out", out.toString());
        assertThat(texts(out)).isEqualTo(texts(MODELS.resolve("converted")));
        assertThat(told)
                .isEqualTo(
                        Files.readString(MODELS.resolve("told.txt"))
                                .replace("OUT", out.toString()));
        assertThat(Tool.run(out, "check", ".")).doesNotContain("error");
    }

    @Test
    void mapsGiveTheVerdictsThatAreMeant() throws Exception {
        Path models = MODELS.resolve("converted");
        assertThat(refines(models, "Motor")).startsWith("holds: ");
        assertThat(refines(models, "WeakMotor"))
                .startsWith("fails: door.made.WeakMotor does not refine door.plan.Door")
                .contains("2  power = 5                 weakMotor: Up");
    }

    private static String refines(Path models, String motor) throws Exception {
        String map = "DoorsOf" + motor;
        return Tool.run(
                models, "refines", "--map", map, "door.made." + motor, "door.plan.Door", ".");
    }

    private static Map<String, String> texts(Path root) throws IOException {
        Map<String, String> texts = new TreeMap<>();
        try (Stream<Path> files = Files.walk(root)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                texts.put(root.relativize(file).toString(), Files.readString(file));
            }
        }
        return texts;
    }
}
