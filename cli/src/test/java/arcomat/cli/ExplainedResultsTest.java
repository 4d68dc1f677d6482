package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.io.Writer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The pages about what {@code verify} and {@code test} find: the wrong models have the finding, the
 * right ones do not.
 */
class ExplainedResultsTest {
    private static final Path PAGES = Path.of("src/main/resources/explain");
    private static final Pattern MODEL =
            Pattern.compile(
                    "```(arc|mt)\n((?:component|testsuite) (\\w+).*?)```\n", Pattern.DOTALL);

    @TempDir Path directory;

    @ParameterizedTest
    @CsvSource({
        "verify, ARC0404",
        "verify, ARC0405",
        "verify, ARC0406",
        "test, ARC0711",
        "test, ARC0712",
        "test, ARC0713"
    })
    void showsTheFindingAndHowItGoes(String command, String code) throws Exception {
        String page = Files.readString(PAGES.resolve(code + ".md"));
        write(page, "## The component");
        write(page, "## Wrong");
        assertThat(run(command)).contains("title=" + code + "::");
        write(page, "## Right");
        assertThat(run(command)).doesNotContain("title=");
    }

    private void write(String page, String heading) throws IOException {
        int start = page.indexOf(heading + "\n");
        assertThat(start).as(heading).isPositive();
        int end = page.indexOf("\n## ", start);
        Matcher model = MODEL.matcher(page.substring(start, end));
        while (model.find()) {
            Path file = directory.resolve(model.group(3) + "." + model.group(1));
            Files.writeString(file, model.group(2));
        }
    }

    private String run(String command) throws InterruptedException {
        StringWriter out = new StringWriter();
        PrintWriter err = new PrintWriter(Writer.nullWriter());
        Embedded.run(directory, new PrintWriter(out), err, command, "--format", "github", ".");
        return out.toString();
    }
}
