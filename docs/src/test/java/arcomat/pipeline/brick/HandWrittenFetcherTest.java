package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.ReachableClasses;
import arcomat.brick.api.BrickTable;
import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;
import arcomat.pipeline.generate.RobotBuilder;
import arcomat.report.brick.BrickTraceText;
import arcomat.report.text.Style;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.sim.script.Action;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.script.Step;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The fetcher that is generated beside two that were written by hand and do the same: how much
 * larger it is, and how much more it does in a slice. {@code -Dtranscripts.update=true} writes the
 * figures into the page about the platform; read there what they are good for.
 */
class HandWrittenFetcherTest {
    private static final Path FOLDER = Path.of("docs/src/test/resources/handwritten");
    private static final Path PAGE = Path.of("docs/platform.md");
    private static final String HEADER =
            "| | of one piece | of parts | generated | against parts | against one piece |";
    private static final int RUNS = 20;
    private static final int SLICES = 100;
    private static final int CYCLE = 100;

    @Tag("slow")
    @Test
    void doTheSameAndCostAboutTheSame() throws IOException {
        Sum lean = new Sum(byHand("lean"));
        Sum parts = new Sum(byHand("parts"));
        Sum generated = new Sum(generated());
        for (Script script : scripts()) {
            String rows = generated.rows(script);
            assertThat(lean.rows(script)).isEqualTo(rows);
            assertThat(parts.rows(script)).isEqualTo(rows);
        }
        assertThat(generated.bytes() / parts.bytes()).isLessThan(1.4);
        assertThat(generated.bytecodes() / parts.bytecodes()).isLessThan(1.5);
        tell(table(lean, parts, generated));
    }

    /** The page says what was counted. */
    private static void tell(String table) throws IOException {
        System.out.println(table);
        String page = Files.readString(PAGE);
        int start = page.indexOf(HEADER);
        int end = page.indexOf("\n\n", start) + 1;
        if (Boolean.getBoolean("transcripts.update")) {
            Files.writeString(PAGE, page.substring(0, start) + table + page.substring(end));
        }
        assertThat(page.substring(start, end)).isEqualTo(table);
    }

    private static List<Script> scripts() throws IOException {
        List<Script> scripts = new ArrayList<>(List.of(script()));
        for (int seed = 0; seed < RUNS; seed++) {
            scripts.add(random(new Random(seed)));
        }
        return scripts;
    }

    private static String table(Sum lean, Sum parts, Sum generated) {
        List<String> rows = new ArrayList<>();
        rows.add(HEADER);
        rows.add("|---|---|---|---|---|---|");
        rows.add(row("classes", Sum::classes, lean, parts, generated));
        rows.add(row("bytes of class files", Sum::bytes, lean, parts, generated));
        rows.add(row("bytecodes a slice", Sum::bytecodes, lean, parts, generated));
        rows.add(row("calls a slice", Sum::calls, lean, parts, generated));
        return String.join("\n", rows) + "\n";
    }

    private static String row(
            String what, ToDoubleFunction<Sum> of, Sum lean, Sum parts, Sum generated) {
        double result = of.applyAsDouble(generated);
        return String.format(
                Locale.ROOT,
                "| %s | %.0f | %.0f | %.0f | %.2f | %.2f |",
                what,
                of.applyAsDouble(lean),
                of.applyAsDouble(parts),
                result,
                result / of.applyAsDouble(parts),
                result / of.applyAsDouble(lean));
    }

    /** Over all runs. */
    private static final class Sum {
        private final CountedProgram program;
        private long slices;
        private long bytecodes;
        private long calls;

        Sum(CountedProgram program) {
            this.program = program;
        }

        String rows(Script script) {
            CountedProgram.Run run = program.run(script, 60_000);
            slices += run.slices();
            bytecodes += run.bytecodes();
            calls += run.calls();
            return BrickTraceText.render(run.rows().trace(), Style.PLAIN);
        }

        double classes() {
            return program.classes();
        }

        double bytes() {
            return program.bytes();
        }

        double bytecodes() {
            return (double) bytecodes / slices;
        }

        double calls() {
            return (double) calls / slices;
        }
    }

    private static CountedProgram byHand(String version) {
        Map<String, String> sources = new HashMap<>();
        try (Stream<Path> files = Files.walk(FOLDER.resolve(version))) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                sources.put(FOLDER.relativize(file).toString(), Files.readString(file));
            }
        } catch (IOException e) {
            throw new AssertionError(e);
        }
        Compilation compilation =
                MemoryCompiler.compile(
                        sources, Map.of(), RobotBuilder.classesOf(BrickTable.leJos()));
        assertThat(compilation.problems()).isEmpty();
        Map<String, byte[]> packed =
                ReachableClasses.from(version + "/Fetcher", compilation.classes()).stream()
                        .collect(Collectors.toMap(name -> name, compilation.classes()::get));
        return new CountedProgram(version + ".Fetcher", packed);
    }

    private static CountedProgram generated() {
        CoffeeRobot robot = CoffeeRobot.of("coffee.fetcher.Fetcher");
        return new CountedProgram(robot.programClass(), robot.program().classes());
    }

    private static Script script() throws IOException {
        Path file = Path.of("models/coffee/scripts/fetcher.script");
        return ScriptParser.parse(Files.readString(file)).script().orElseThrow();
    }

    /** Values that stay for a while, near the thresholds of the models and far from them. */
    private static Script random(Random random) {
        List<Step> steps = new ArrayList<>();
        for (int slice = 0; slice < SLICES; slice++) {
            for (SensorName socket : SensorName.values()) {
                if (slice == 0 || random.nextInt(4) == 0) {
                    int value = socket == SensorName.S4 ? random.nextInt(2) : random.nextInt(100);
                    steps.add(
                            new Step(
                                    (long) slice * CYCLE,
                                    new Action.Expose(socket, Stimulus.value(value))));
                }
            }
        }
        steps.add(new Step((long) SLICES * CYCLE, new Action.End()));
        return new Script(steps);
    }
}
