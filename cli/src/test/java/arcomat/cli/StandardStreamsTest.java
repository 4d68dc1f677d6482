package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.cli.Shell.Outcome;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;

/** The installed command where standard output is full, closed, or read only in part. */
@Tag("distribution")
class StandardStreamsTest {
    @TempDir private Path temporary;

    private Outcome shell(String line) throws Exception {
        return new Shell(temporary).run(line);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "--help",
                "--version",
                "check --help",
                "explain",
                "check $M",
                "simulate --slices 2000 --trace csv --main coffee.fetcher.Fetcher $M",
                "simulate --slices 2 --trace json --main coffee.fetcher.Fetcher $M"
            })
    void aResultThatCannotBeWrittenIsSaidOnce(String command) throws Exception {
        Outcome full = shell("$A " + command + " >/dev/full");
        assertThat(full.err())
                .matches("arcomat: standard output cannot be written, results are missing: .+\n");
        assertThat(full.status()).isEqualTo(2);
    }

    @Test
    void soIsOneThatIsClosed() throws Exception {
        Outcome closed = shell("$A check $M >&-");
        assertThat(closed.err())
                .startsWith("arcomat: standard output cannot be written")
                .hasLineCount(1);
        assertThat(closed.status()).isEqualTo(2);
        assertThat(shell("$A check $M >&- 2>&-").status()).isEqualTo(2);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "LANG=de_DE.UTF-8 LC_ALL=de_DE.UTF-8"})
    void aReaderWhoHasHadEnoughIsNotTold(String environment) throws Exception {
        String simulate = "simulate --slices 5000 --trace csv --main coffee.fetcher.Fetcher $M";
        Outcome head = shell(environment + " $A " + simulate + " | head -1; exit ${PIPESTATUS[0]}");
        assertThat(head.err()).isEmpty();
        assertThat(head.out()).hasLineCount(1);
        assertThat(head.status()).isZero();
    }

    /** Long work: it would be told of after a second. */
    @Test
    void progressIsToldOnATerminalOrWhereItIsAskedFor() throws Exception {
        String simulate =
                "\"$A\" simulate --slices 100000 --trace csv --main coffee.fetcher.Fetcher \"$M\"";
        assertThat(shell(simulate + " >/dev/null").err()).isEmpty();
        assertThat(shell(simulate + " --progress >/dev/null").err()).contains("simulating ...\n");
        assumeTrue(shell("command -v script").status() == 0, "script makes terminals");
        assertThat(shell("script -qec '" + simulate + " >/dev/null' /dev/null").out())
                .contains("simulating ...");
    }

    @Test
    void tablesAndHelpFitTheTerminal() throws Exception {
        String[] commands = {
            "simulate --slices 5 --main coffee.fetcher.Fetcher \"$M\"", "simulate --help", "--help"
        };
        for (String command : commands) {
            assertThat(shell("COLUMNS=90 \"$A\" " + command).out().lines())
                    .allMatch(line -> line.length() <= 90);
        }
        assumeTrue(shell("command -v script").status() == 0, "script makes terminals");
        for (String command : commands) {
            String seen = "stty cols 70; NO_COLOR=1 \"$A\" " + command;
            assertThat(shell("unset COLUMNS; script -qec '" + seen + "' /dev/null").out().lines())
                    .allMatch(line -> line.stripTrailing().length() <= 70);
        }
    }
}
