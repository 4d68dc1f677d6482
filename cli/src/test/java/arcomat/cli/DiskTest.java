package arcomat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * The installed tool, killed again and again while it keeps on disk what it explores: at last it
 * answers what a process says that keeps all in memory and is left alone.
 */
@Tag("distribution")
@Timeout(600)
class DiskTest {
    private static final int CELLS = 18;
    private static final int KILLS = 4;
    private static final int FINE = 0;

    /** So little that it is written often. */
    private static final Map<String, String> SMALL =
            Map.of("JAVA_OPTS", "-Xmx48m -XX:+UseSerialGC");

    private static final String CELL =
            """
            component Cell {
                port in Boolean x, out Boolean o;
                <<completion = "ignore">> automaton {
                    state s;
                    initial s;
                    s {x == true} / {o = true};
                }
            }
            """;

    private static final String ANY =
            """
            component Any {
                port in Boolean x, out Boolean o;
                <<completion = "output">> automaton {
                    state s;
                    initial s;
                }
            }
            """;

    @TempDir private Path temporary;
    private ToolProcesses tool;

    @BeforeEach
    void writeModels() throws IOException {
        tool = new ToolProcesses(temporary);
        Path models = Files.createDirectories(temporary.resolve("m"));
        Files.writeString(models.resolve("Cell.arc"), CELL);
        Files.writeString(models.resolve("Any.arc"), ANY);
        Files.writeString(models.resolve("Row.arc"), row());
    }

    private static String row() {
        StringBuilder text =
                new StringBuilder(
                        "component Row refines Any {\nport in Boolean x, out Boolean o;\n");
        String before = "x";
        for (int cell = 0; cell < CELLS; cell++) {
            text.append(
                    "component Cell c%d;\nconnect %s -> c%d.x;\n".formatted(cell, before, cell));
            before = "c" + cell + ".o";
        }
        return text + "connect " + before + " -> o;\ninv neverFalse: o == -- || o;\n}\n";
    }

    @AfterEach
    void endAll() throws InterruptedException {
        tool.endAll();
    }

    @Test
    void goesOnAfterItWasKilled() throws Exception {
        assertThat(tool.start("memory", List.of("verify", "m")).waitFor()).isEqualTo(FINE);
        assertThat(tool.log("memory")).contains("2 hold, 0 fail, 0 unknown");
        for (int kill = 0; kill < KILLS; kill++) {
            killAfterACommit();
        }
        assertThat(onDisk("killed").waitFor()).isEqualTo(FINE);
        assertThat(tool.log("killed")).isEqualTo(inMemory());
        assertThat(onDisk("again").waitFor()).isEqualTo(FINE);
        assertThat(tool.log("again")).isEqualTo(inMemory());
    }

    /** Without what the second engine has proved meanwhile, which is not asked beside files. */
    private String inMemory() throws IOException {
        return tool.log("memory").replaceAll("; proved symbolically.*", "");
    }

    private Process onDisk(String log) throws IOException {
        return tool.start(log, List.of("verify", "--disk", "explored", "m"), SMALL);
    }

    /** As soon as it has written something more. */
    private void killAfterACommit() throws Exception {
        List<String> before = committed();
        Process process = onDisk("log");
        while (committed().equals(before)) {
            assertThat(process.isAlive()).as(tool.log("log")).isTrue();
            Thread.sleep(1);
        }
        process.destroyForcibly().waitFor();
    }

    /** What was committed, with the moment; other files come and go. */
    private List<String> committed() {
        List<String> found = new ArrayList<>();
        for (File promise : inside(temporary.resolve("explored").toFile())) {
            for (File search : inside(promise)) {
                File committed = new File(search, "committed");
                if (committed.exists()) {
                    found.add(committed + " " + committed.lastModified());
                }
            }
        }
        return found;
    }

    private static File[] inside(File folder) {
        File[] files = folder.listFiles();
        return files == null ? new File[0] : files;
    }
}
