package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.generate.RobotBuilder.BrickProgram;
import arcomat.report.brick.BrickTraceText;
import arcomat.report.text.Style;
import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;

import com.sun.management.OperatingSystemMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.jar.JarEntry;
import java.util.jar.JarInputStream;

/**
 * The robots of the case study on simulated bricks: what they do over the scripts that come with
 * them, and what they cost. {@code -PrefreshGolden} writes the expected runs anew; read them.
 */
class CoffeeRobotTest {
    private static final int JAVA_6 = 50;
    private static final String FETCHER = "coffee.fetcher.Fetcher";

    @TempDir private Path folder;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "coffee.fetcher.Fetcher",
                "coffee.dispenser.Dispenser",
                "coffee.preparer.Preparer"
            })
    void doesWhatItsScriptAsksFor(String name) throws Exception {
        String simple = name.substring(name.lastIndexOf('.') + 1).toLowerCase();
        Path jar = Files.write(folder.resolve("robot.jar"), CoffeeRobot.of(name).jar());
        RunJar task =
                new RunJar(
                        jar.toString(),
                        Optional.of("models/coffee/scripts/" + simple + ".script"),
                        OptionalInt.empty());
        RunJar.Run run = Session.in(Path.of(""), Progress.NONE).run(task).run().orElseThrow();
        assertThat(run.failure()).isEmpty();
        String actual = BrickTraceText.render(run.trace(), Style.PLAIN) + run.ending() + "\n";
        Path expected = Path.of("src/test/resources/robots", simple + ".txt");
        if (Boolean.getBoolean("golden.refresh")) {
            Files.writeString(expected, actual);
        }
        assertThat(actual).isEqualTo(Files.readString(expected));
    }

    @Test
    void theFetcherIsSmall() {
        BrickProgram fetcher = CoffeeRobot.of(FETCHER).built().robots().get(0);
        assertThat(fetcher.report().classes()).isLessThanOrEqualTo(60);
        assertThat(fetcher.report().bytes()).isLessThanOrEqualTo(40_000);
    }

    @Test
    void aJarHoldsClassesOfJava6AndItsManifestAndNothingElse() throws IOException {
        CoffeeRobot robot = CoffeeRobot.of(FETCHER);
        List<String> others = new ArrayList<>();
        try (JarInputStream jar = new JarInputStream(new ByteArrayInputStream(robot.jar()))) {
            assertThat(jar.getManifest().getMainAttributes())
                    .hasSize(2)
                    .containsValue("coffee.fetcher.logic.FetcherProgram");
            for (JarEntry entry = jar.getNextJarEntry(); entry != null; ) {
                if (entry.getName().endsWith(".class")) {
                    assertThat(jar.readAllBytes()[7]).as(entry.getName()).isEqualTo((byte) JAVA_6);
                } else {
                    others.add(entry.getName());
                }
                entry = jar.getNextJarEntry();
            }
        }
        assertThat(others).isEmpty();
    }

    @Test
    void theSameModelGivesTheSameBytes() {
        CoffeeRobot robot = CoffeeRobot.of(FETCHER);
        assertThat(robot.builtAgain().jars().get("Fetcher.jar")).isEqualTo(robot.jar());
    }

    /** What the program's own thread allocates, once everything has been loaded and said. */
    @Test
    void aCycleAllocatesNothing() {
        AllocationObserver allocations = new AllocationObserver();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = lively(laboratory);
            brick.observe(allocations);
            laboratory.runToEnd(60_000);
        }
        assertThat(allocations.cycles()).isGreaterThan(500);
        assertThat(allocations.bytes()).isZero();
    }

    /** Ten minutes of the robot's time, by the processor's clock: the machine may be busy. */
    @Test
    void aMinuteTakesAFifthOfASecond() {
        OperatingSystemMXBean system =
                (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        try (Laboratory laboratory = new Laboratory()) {
            lively(laboratory);
            long before = system.getProcessCpuTime();
            laboratory.runToEnd(600_000);
            assertThat(system.getProcessCpuTime() - before).isLessThan(2_000_000_000L);
            assertThat(laboratory.time()).isEqualTo(600_000);
        }
    }

    private static SimulatedBrick lively(Laboratory laboratory) {
        SimulatedBrick brick = laboratory.place("fetcher", CoffeeRobot.of(FETCHER).program());
        brick.expose(SensorName.S1, Stimulus.value(100));
        brick.expose(SensorName.S2, Stimulus.value(20));
        brick.expose(SensorName.S3, Stimulus.value(20));
        brick.expose(SensorName.S4, Stimulus.value(0));
        return brick;
    }
}
