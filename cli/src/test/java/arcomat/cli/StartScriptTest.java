package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;

/** The start script with a Java that only tells its arguments. */
class StartScriptTest {
    private static final String JAVA = "#!/bin/sh\nfor each; do printf '[%s]\\n' \"$each\"; done\n";

    @TempDir private Path folder;
    private Path script;

    @BeforeEach
    void install() throws IOException {
        script =
                executable("bin/arcomat", Files.readString(Path.of("src/main/scripts/arcomat.sh")));
        executable("java/bin/java", JAVA);
    }

    private Path executable(String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }

    private record Said(List<String> lines, int status) {}

    private Said start(String options, String... arguments) throws Exception {
        ProcessBuilder command = new ProcessBuilder(script.toString());
        command.command().addAll(List.of(arguments));
        command.environment().put("ARCOMAT_ARCHIVE", "none");
        command.environment().put("JAVA_OPTS", options);
        Process process = command.redirectErrorStream(true).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        return new Said(text.lines().toList(), process.waitFor());
    }

    /** Takes words apart as start scripts of Gradle do. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "-Xmx1g                        | [-Xmx1g]",
                "-Xmx1g   -ea                  | [-Xmx1g][-ea]",
                "-Da='x y' -Db=\"it's z\"      | [-Da=x y][-Db=it's z]",
                "'-Da=x y'                     | [-Da=x y]",
                "-Da=x\\ y                     | [-Da=x y]",
                "-Da='\"x\"'                   | [-Da=\"x\"]",
                "-Da=* -Db=$HOME -Dc=$(ls);ls  | [-Da=*][-Db=$HOME][-Dc=$(ls);ls]",
                "-Dä=ö                         | [-Dä=ö]"
            })
    void optionsOfJavaMayBeQuoted(String options, String expected) throws Exception {
        Said said = start(options, "check", "a b", "$HOME", "");
        assertThat(said.status()).isZero();
        assertThat(String.join("", said.lines()))
                .endsWith(
                        expected
                                + "[-classpath][@classpath@][arcomat.cli.Main]"
                                + "[check][a b][$HOME][]");
    }

    @Test
    void noOptionsAreNone() throws Exception {
        assertThat(start(" ", "check")).isEqualTo(start("", "check"));
    }

    @Test
    void aQuoteThatIsOpenIsRefused() throws Exception {
        Said said = start("-Da='x", "check");
        assertThat(said.status()).isEqualTo(2);
        assertThat(said.lines())
                .containsExactly(
                        "arcomat: JAVA_OPTS cannot be read: close each quote, and have xargs on the"
                                + " path");
    }
}
