package arcomat.pipeline.gate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.analysis.evolution.Change.Relation;
import arcomat.analysis.evolution.Gate;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.analysis.AnalysisLimits;
import arcomat.pipeline.check.CheckFiles;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** What the gate costs, and what it takes for a change. */
class GateTest {
    private static final Path COFFEE = Path.of("models/coffee/coffee");

    /** What is compared is asked here, not what comes of it: a fetcher has a great many states. */
    private static final AnalysisLimits LIMITS =
            new AnalysisLimits(Optional.of(Duration.ofSeconds(2)), Optional.of(5_000L));

    @TempDir Path folder;
    private final List<String> steps = new ArrayList<>();
    private Session session;

    @BeforeEach
    void open() {
        session = Session.in(folder, steps::add);
    }

    @Test
    void nothingIsSearchedForWhatDidNotChange() throws Exception {
        copy(COFFEE, "old/coffee");
        copy(COFFEE, "new/coffee");

        assertThat(gate().entries()).hasSizeGreaterThan(15);
        assertThat(relations()).containsOnly(Relation.UNCHANGED);
        assertThat(steps).noneMatch(step -> step.startsWith("comparing"));
    }

    /** Comments and layout are no change, whatever they stand beside. */
    @Test
    void textWithTheSameMeaningIsUnchanged() throws Exception {
        copy(COFFEE, "old/coffee");
        copy(COFFEE, "new/coffee");
        try (Stream<Path> files = Files.walk(folder.resolve("new"))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                String text = Files.readString(file);
                String other =
                        "/* moved */\n\n"
                                + text.replaceAll("(?m)^ *//.*\n", "")
                                        .replaceAll("(?s)/\\*\\*.*?\\*/", "")
                                        .replace("    ", "\t")
                                        .replace("{", "{\n");
                assertThat(other).isNotEqualTo(text);
                Files.writeString(file, other);
            }
        }

        assertThat(relations()).containsOnly(Relation.UNCHANGED);
    }

    /** A type that changes is a change of those who use it, and of those made of them. */
    @Tag("slow")
    @Test
    void whatDependsOnAChangeIsChanged() throws Exception {
        copy(COFFEE, "old/coffee");
        copy(COFFEE, "new/coffee");
        Path types = folder.resolve("new/coffee/types/Types.cd");
        String text = Files.readString(types);
        String more = text.replaceFirst("enum TimerCmd \\{", "$0 hurry,");
        assertThat(more).isNotEqualTo(text);
        Files.writeString(types, more);

        List<String> changed =
                gate().entries().stream()
                        .filter(entry -> entry.change().relation() != Relation.UNCHANGED)
                        .map(Gate.Entry::name)
                        .toList();
        assertThat(changed)
                .contains("coffee.parts.Timer", "coffee.fig5.AvoidCrash", "coffee.fetcher.Fetcher")
                .doesNotContain("coffee.fetcher.CupHolder", "coffee.fetcher.Drive");
    }

    /**
     * Both sides are read and checked; the comparison adds little. Memory that is asked for is what
     * work is measured by here: whatever else the machine does, it is the same.
     */
    @Tag("slow")
    @Test
    void unchangedComponentsCostAboutTwoChecks() throws Exception {
        for (int i = 0; i < 300; i++) {
            write("old/p/C" + i + ".arc", component(i));
            write("new/p/C" + i + ".arc", component(i));
        }

        session.run(new CheckFiles(List.of("old"), false));
        long check = allocated(() -> session.run(new CheckFiles(List.of("new"), false)));
        List<String> twoChecks = List.copyOf(steps);
        steps.clear();
        long gate = allocated(() -> assertThat(gate().entries()).hasSize(300));

        assertThat(steps.subList(0, twoChecks.size())).isEqualTo(twoChecks);
        assertThat(steps.subList(twoChecks.size(), steps.size())).containsOnly("lowering");
        assertThat((double) gate / check).as("checks that a gate costs").isBetween(1.5, 3.0);
    }

    /**
     * Bytes that it asks for, whoever parses the files: which thread does is a matter of luck. What
     * threads asked for before does not count, also where they end meanwhile.
     */
    private static long allocated(ThrowingRunnable work) throws WrongUse {
        Map<Long, Long> before = allocatedByThread();
        work.run();
        return allocatedByThread().entrySet().stream()
                .mapToLong(each -> each.getValue() - before.getOrDefault(each.getKey(), 0L))
                .sum();
    }

    private static Map<Long, Long> allocatedByThread() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long[] ids = threads.getAllThreadIds();
        long[] bytes = threads.getThreadAllocatedBytes(ids);
        Map<Long, Long> allocated = new HashMap<>();
        for (int i = 0; i < ids.length; i++) {
            if (bytes[i] > 0) {
                allocated.put(ids[i], bytes[i]);
            }
        }
        return allocated;
    }

    private interface ThrowingRunnable {
        void run() throws WrongUse;
    }

    private static String component(int number) {
        return """
        package p;

        component C%d {
            port in Integer[0..7] a, in Boolean b, out Integer[0..7] o;

            <<completion = "ignore">> automaton {
                variable Integer[0..7] n = 0;
                state idle, busy, done;

                initial idle;

                idle -> busy [n < %d] {b == true} / {o = n};
                busy -> done {a == %d, b == true} / {o = a, n = a};
                done -> idle {b == false} / {o = 3};
            }
        }
        """
                .formatted(number, number % 7 + 1, number % 7);
    }

    private Gate gate() throws WrongUse {
        PassGate task = new PassGate(List.of("old"), List.of("new"), LIMITS);
        return session.run(task).gate().orElseThrow();
    }

    private List<Relation> relations() throws WrongUse {
        return gate().entries().stream().map(entry -> entry.change().relation()).toList();
    }

    private void copy(Path source, String target) throws IOException {
        try (Stream<Path> files = Files.walk(source)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                write(target + "/" + source.relativize(file), Files.readString(file));
            }
        }
    }

    private void write(String path, String text) throws IOException {
        Path file = folder.resolve(path);
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
    }
}
