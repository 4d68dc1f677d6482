package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Shell.Outcome;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Files;
import java.nio.file.Path;

/** Names of files and output are UTF-8, whatever the locale of the process. */
@Tag("distribution")
class LocaleTest {
    private static final String ONLY_ITS_PATH = "env -i PATH=\"$PATH\" ";

    @TempDir private Path temporary;

    @BeforeEach
    void writeModelsWithNamesInOtherLetters() throws Exception {
        Path folder = Files.createDirectories(temporary.resolve("käse/q"));
        Files.writeString(
                folder.resolve("Robot.arc"),
                """
                package q;

                component Robot {
                    port in Integer distance, out Integer speed;

                    <<requirement = "über">>
                    automaton {
                        state s;
                        initial s;
                        s / {speed = 1};
                    }
                }
                """);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "LC_ALL=C "})
    void namesAndOutputAreUtf8(String locale) throws Exception {
        String[] commands = {
            "check käse",
            "check käse/q/Robot.arc",
            "format --check \"$PWD/käse\"",
            "simulate --slices 2 --main q.Robot --record käse/q/Run.mt käse",
            "generate --target jvm --out erzeugt/ü käse",
            "analyze käse",
            "check käse/fehlt"
        };
        for (String command : commands) {
            Outcome expected = run("LC_ALL=C.UTF-8 ", command);
            assertThat(run(locale, command)).isEqualTo(expected);
            assertThat(expected.out() + expected.err())
                    .doesNotContain("internal error", "?", "\ufffd");
        }
        assertThat(temporary.resolve("käse/q/Run.mt")).exists();
    }

    private Outcome run(String locale, String command) throws Exception {
        return new Shell(temporary).run(ONLY_ITS_PATH + locale + "\"$A\" " + command);
    }

    @Test
    void withoutTheStartScriptItSaysWhatToDo() throws Exception {
        Outcome outcome =
                new Shell(temporary)
                        .run(
                                ONLY_ITS_PATH
                                        + "LC_ALL=C java -cp \"${A%/bin/*}/lib/*\" arcomat.cli.Main"
                                        + " check käse");
        assertThat(outcome.err())
                .contains("cannot be the name of a file; Java writes names of files in ")
                .contains("LC_ALL=C.UTF-8");
        assertThat(outcome.status()).isEqualTo(2);
    }
}
