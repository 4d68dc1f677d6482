package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** The installed command, while files are saved, until somebody presses Ctrl-C. */
@Tag("distribution")
class WatchTest {
    private static final Path COMMAND =
            Path.of("build/install/arcomat/bin/arcomat").toAbsolutePath();
    private static final String WELL = "all is well";
    private static final String BROKEN = "something is broken";

    @TempDir private Path folder;

    /** Hears Ctrl-C, also where whoever started the tests in the background does not. */
    private Process watch(String... options) throws IOException {
        List<String> command =
                new ArrayList<>(
                        List.of("env", "--default-signal=INT", COMMAND.toString(), "watch"));
        command.addAll(List.of(options));
        command.add("mower");
        return new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("said").toFile())
                .start();
    }

    private String said() throws IOException {
        return Files.readString(folder.resolve("said"));
    }

    /** Waits until something was said so often, and returns what was said since the last save. */
    private String until(String line, int times) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(120);
        while (said().split(line, -1).length <= times) {
            assertThat(System.nanoTime()).as(said()).isLessThan(end);
            Thread.sleep(20);
        }
        String all = said();
        return all.substring(Math.max(0, all.lastIndexOf("saved: ")));
    }

    private void saveByRename(Path file, String text) throws IOException {
        Path beside = folder.resolve("beside");
        Files.writeString(beside, text);
        Files.move(beside, file, StandardCopyOption.REPLACE_EXISTING);
    }

    private static int endByControlC(Process process) throws Exception {
        new ProcessBuilder("kill", "-INT", String.valueOf(process.pid())).start().waitFor();
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        return process.exitValue();
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"--progress", "--poll"})
    void saysAtEachSaveWhatIsBroken(String option) throws Exception {
        new Shell(folder).run("$A new mower");
        Path pilot = folder.resolve("mower/src/main/arc/mower/MowerPilot.arc");
        String good = Files.readString(pilot);
        Process process = watch(option);
        try {
            until(WELL, 1);
            Files.writeString(pilot, good.replace("<= 30", "<= 10").replace("> 30", "> 10"));
            assertThat(until(BROKEN, 1))
                    .contains("1 passed, 1 failed", "0 hold, 1 fail", "no collision");
            Files.writeString(pilot, good.substring(0, good.length() / 2));
            assertThat(until(BROKEN, 2)).contains("some wait until errors are mended");
            saveByRename(pilot, good);
            assertThat(until(WELL, 2)).contains("2 passed, 0 failed", "1 hold, 0 fail");
            assertThat(endByControlC(process)).isZero();
        } finally {
            process.destroyForcibly();
        }
    }

    @ParameterizedTest(name = "{0}")
    @ValueSource(strings = {"--progress"})
    void endsWithTheStatusOfWhatIsBroken(String option) throws Exception {
        new Shell(folder).run("$A new mower");
        Files.writeString(folder.resolve("mower/src/main/arc/mower/Mower.arc"), "component");
        Process process = watch(option);
        try {
            until(BROKEN, 1);
            assertThat(endByControlC(process)).isEqualTo(1);
        } finally {
            process.destroyForcibly();
        }
    }
}
