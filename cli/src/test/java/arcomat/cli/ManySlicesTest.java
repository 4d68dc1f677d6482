package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.cli.Shell.Outcome;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;

/** Runs of more slices than there is memory for. */
@Tag("distribution")
class ManySlicesTest {
    /** Of which each one kept would take some hundred bytes. */
    private static final int SLICES = 300_000;

    private static final Map<String, String> LITTLE_MEMORY = Map.of("JAVA_OPTS", "-Xmx24m");

    @TempDir private Path temporary;

    @BeforeEach
    void writeModel() throws Exception {
        Files.writeString(
                temporary.resolve("Counter.arc"),
                """
                component Counter {
                  port in Boolean go, out Integer count;
                  <<completion = "ignore">> automaton {
                    variable Integer[0..9] k = 0;
                    state s;
                    initial s;
                    s [k < 9] {go == true} / {k = k + 1, count = k};
                    s [k < 9] {go == true} / {count = 0};
                    s [k == 9] / {k = 0};
                  }
                }
                """);
    }

    @ParameterizedTest
    @CsvSource({"csv, '^[0-9]+,'", "json, number", "table, '^ *[0-9]+  '"})
    @Timeout(300)
    void areWrittenAsTheyGo(String format, String perSlice) throws Exception {
        String line =
                "$A simulate --main Counter --choose random --monitor Counter --trace %s"
                        + " --slices %d . | grep -cE '%s'; exit ${PIPESTATUS[0]}";
        Outcome outcome =
                new Shell(temporary).run(line.formatted(format, SLICES, perSlice), LITTLE_MEMORY);
        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.out().strip()).isEqualTo(String.valueOf(SLICES));
        assertThat(outcome.status()).isZero();
    }

    @Test
    @Timeout(120)
    void endWhenNobodyReadsOn() throws Exception {
        Outcome outcome =
                new Shell(temporary)
                        .run(
                                "$A simulate --main Counter --trace csv --slices 2000000000 . |"
                                        + " head -2; exit ${PIPESTATUS[0]}",
                                LITTLE_MEMORY);
        assertThat(outcome.out()).startsWith("slice,in go,out count,").hasLineCount(2);
        assertThat(outcome.err()).isEmpty();
        assertThat(outcome.status()).isZero();
    }
}
