package arcomat.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.report.text.Style;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

import java.io.BufferedReader;
import java.io.PrintWriter;
import java.io.Reader;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/** Work that looks at no clock. */
class LastMomentTest {
    private final CompletableFuture<Integer> status = new CompletableFuture<>();
    private final StringWriter err = new StringWriter();

    private final Console console =
            new Console(
                    Path.of(""),
                    new PrintWriter(new StringWriter()),
                    new PrintWriter(err),
                    new BufferedReader(Reader.nullReader()),
                    Style.PLAIN,
                    false,
                    status::complete,
                    Optional::empty);

    @Test
    @Timeout(60)
    void theProcessIsEndedAWhileAfterItsTime() throws Exception {
        LastMoment.await(System.nanoTime() - TimeUnit.SECONDS.toNanos(10), console);
        assertThat(status.get()).isEqualTo(3);
        assertThat(err.toString())
                .startsWith("arcomat: unknown: the time is up; allow it more with --timeout");
    }

    @Test
    void notBeforeItHasHadTheTimeToSayWhatItFound() throws Exception {
        LastMoment.await(System.nanoTime(), console);
        Thread.sleep(500);
        assertThat(status.isDone()).isFalse();
    }
}
