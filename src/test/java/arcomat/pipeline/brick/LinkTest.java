package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Linking with stand-ins for leJOS' linker; with the real one where NXJ_HOME says where it is. */
class LinkTest {
    private static final String WRITE_PROGRAM =
            "while [ $# -gt 1 ]; do [ \"$1\" = --output ] && program=$2; shift; done\n"
                    + "printf linked > \"$program\"\n";

    @TempDir private Path folder;

    @BeforeEach
    void putTheJarThere() throws IOException {
        byte[] jar = CoffeeRobot.of("coffee.fetcher.Fetcher").jar();
        Files.write(folder.resolve("Fetcher.jar"), jar);
    }

    private void linker(String script) throws IOException {
        Path file = folder.resolve("lejos/bin/nxjlink");
        Files.createDirectories(file.getParent());
        Files.writeString(file, "#!/bin/sh\n" + script);
        assumeTrue(file.toFile().setExecutable(true));
    }

    private LinkJar.Result link(Optional<String> home, int seconds) throws WrongUse {
        LinkJar task = new LinkJar("Fetcher.jar", Optional.empty(), home, seconds);
        return Session.in(folder, Progress.NONE).run(task);
    }

    private LinkJar.Result link() throws WrongUse {
        return link(Optional.of("lejos"), 20);
    }

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void startsTheLinkerWithTheClassesAndTheMainClassAndAssertionsOn() throws Exception {
        Path notes = folder.resolve("lejos/notes");
        linker(
                "echo \"$JAVA_TOOL_OPTIONS|$NXJ_HOME|$1|$2|$4|$#\" > '"
                        + notes
                        + "'\nls coffee/fetcher/logic/FetcherProgram.class nxt/sensors >> '"
                        + notes
                        + "'\necho 'Class records    : 128 (1536 bytes).'\n"
                        + WRITE_PROGRAM);
        LinkJar.Result result = link();
        assertThat(result.failure()).isEmpty();
        assertThat(result.linked().orElseThrow().path()).isEqualTo("Fetcher.nxj");
        assertThat(result.linked().orElseThrow().bytes()).isEqualTo(6);
        assertThat(result.linked().orElseThrow().classes()).hasValue(128);
        assertThat(folder.resolve("Fetcher.nxj")).hasContent("linked");
        assertThat(Files.readString(notes))
                .contains("-ea|" + folder.resolve("lejos"))
                .contains("|--verbose|--output|coffee.fetcher.logic.FetcherProgram|4")
                .contains("coffee/fetcher/logic/FetcherProgram.class")
                .contains("UltrasonicSensor.class");
    }

    @Test
    void aLinkerThatFailsIsHeard() throws Exception {
        linker("echo 'Exception: class java.util.Objects not found' >&2\nexit 3\n");
        LinkJar.Result result = link();
        assertThat(result.linked()).isEmpty();
        assertThat(result.failure()).contains("nxjlink failed with exit status 3");
        assertThat(result.output()).containsExactly("Exception: class java.util.Objects not found");
        assertThat(files()).containsExactly("Fetcher.jar", "lejos");
    }

    /** With assertions on, the linker lists all it has and dies of the class that is too many. */
    @Test
    void ofManyLinesTheOneThatMattersIsSaid() throws Exception {
        linker(
                """
                i=0
                while [ $i -lt 880 ]; do echo "Method $i: Class: p.C Signature: run()V"; i=$((i+1)); done
                echo 'Class records    : 277 (3324 bytes).'
                echo 'Exception in thread "main" java.lang.AssertionError: Not a byte' >&2
                echo '\tat js.tinyvm.ClassRecord.dump(ClassRecord.java:1)' >&2
                exit 1
                """);
        LinkJar.Result result = link();
        assertThat(result.failure().orElseThrow())
                .startsWith("the linked program has 277 classes, and the brick has room for 256");
        assertThat(result.output())
                .containsExactly(
                        "Exception in thread \"main\" java.lang.AssertionError: Not a byte");
        assertThat(result.log()).contains("Fetcher.nxjlink.log");
        assertThat(folder.resolve("Fetcher.nxjlink.log")).content().hasLineCount(883);
        assertThat(files()).containsExactly("Fetcher.jar", "Fetcher.nxjlink.log", "lejos");
    }

    @Test
    void aLinkerThatHangsIsStoppedWithItsChildren() throws Exception {
        linker("echo $$ > '" + folder.resolve("lejos/process") + "'\nsleep 300 & wait\n");
        long start = System.nanoTime();
        LinkJar.Result result = link(Optional.of("lejos"), 2);
        assertThat(Duration.ofNanos(System.nanoTime() - start)).isLessThan(Duration.ofMinutes(2));
        assertThat(result.failure())
                .contains(
                        "nxjlink has not ended after 2 seconds and was stopped; allow it more with"
                                + " --limit");
        long process = Long.parseLong(Files.readString(folder.resolve("lejos/process")).strip());
        // On a busy machine it takes a moment until the system knows.
        for (ProcessHandle linker : ProcessHandle.of(process).stream().toList()) {
            assertThat(linker.onExit()).succeedsWithin(Duration.ofSeconds(20));
        }
        assertThat(files()).containsExactly("Fetcher.jar", "lejos");
    }

    @Test
    void aLinkerThatWritesNothingHasFailed() throws Exception {
        linker("exit 0\n");
        assertThat(link().failure())
                .contains("nxjlink ended without an error, but wrote no program");
    }

    /** The shipped scripts write a broken file and return 0 when there are too many classes. */
    @Test
    void aProgramThatIsTooLargeIsNotKept() throws Exception {
        linker("echo 'Class records    : 257 (3084 bytes).'\n" + WRITE_PROGRAM);
        assertThat(link().failure().orElseThrow())
                .startsWith("the linked program has 257 classes, and the brick has room for 256");
        linker(WRITE_PROGRAM + "head -c 65536 /dev/zero > \"$program\"\n");
        assertThat(link().failure().orElseThrow())
                .startsWith("the linked program has 65536 bytes, and the brick has room for 65535");
        assertThat(files()).containsExactly("Fetcher.jar", "lejos");
    }

    @Test
    void withoutALinkerItSaysHowToGetThere() {
        assertThatThrownBy(() -> link(Optional.empty(), 20))
                .isInstanceOf(WrongUse.class)
                .hasMessage(
                        "linking needs leJOS NXJ 0.9.1: install it, set NXJ_HOME to its folder, and"
                                + " run 'arcomat link --jar Fetcher.jar' again");
        assertThatThrownBy(() -> link(Optional.of("elsewhere"), 20))
                .isInstanceOf(WrongUse.class)
                .hasMessageStartingWith("'elsewhere' is not a folder of leJOS NXJ: ");
    }

    @Test
    void theRealLinkerAgrees() throws Exception {
        String home = System.getenv("NXJ_HOME");
        assumeTrue(home != null);
        LinkJar.Result result = link(Optional.of(home), 120);
        assertThat(result.failure()).isEmpty();
        assertThat(result.linked().orElseThrow().classes().orElseThrow())
                .isEqualTo(result.report().needs().classes());
    }
}
