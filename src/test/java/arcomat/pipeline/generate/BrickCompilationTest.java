package arcomat.pipeline.generate;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.api.BrickTable;
import arcomat.pipeline.compile.ClassFiles;
import arcomat.pipeline.compile.Compilation;
import arcomat.pipeline.compile.MemoryCompiler;

import org.junit.jupiter.api.Test;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/** Java for the brick, compiled in memory against what the brick has. */
class BrickCompilationTest {
    private static final ClassFiles BRICK = RobotBuilder.classesOf(BrickTable.leJos());

    @Test
    void classesKnowTheFileThatTheyComeFrom() {
        Map<String, String> sources = new LinkedHashMap<>();
        sources.put(
                "robot/Eye.java",
                """
                package robot;
                public class Eye {
                    enum Mode { ON, OFF }
                    private final lejos.nxt.LightSensor sensor;
                    public Eye() { sensor = new lejos.nxt.LightSensor(lejos.nxt.SensorPort.S1); }
                    public int read() { return sensor.getLightValue(); }
                }
                """);
        sources.put(
                "Main.java",
                """
                import java.util.*;
                public class Main {
                    public static void main(String[] arguments) {
                        Map<String, Integer> seen = new HashMap<String, Integer>();
                        for (Map.Entry<String, Integer> each : seen.entrySet()) each.getKey();
                        seen.put("eye", new robot.Eye().read());
                    }
                }
                """);

        Compilation compilation = MemoryCompiler.compile(sources, Map.of(), BRICK);

        assertThat(compilation.problems()).isEmpty();
        assertThat(compilation.sources())
                .isEqualTo(
                        Map.of(
                                "robot/Eye", "robot/Eye.java",
                                "robot/Eye$Mode", "robot/Eye.java",
                                "Main", "Main.java"));
        assertThat(compilation.classes().keySet()).isEqualTo(compilation.sources().keySet());
    }

    @Test
    void aFileOnDemandIsCompiledWhereSomethingRefersToIt() {
        Map<String, String> onDemand =
                Map.of(
                        "robot/Eye.java", "package robot; public class Eye {}",
                        "robot/Ear.java", "package robot; public class Ear { this is no Java }");

        Compilation compilation =
                MemoryCompiler.compile(
                        Map.of("Main.java", "class Main { robot.Eye eye; }"), onDemand, BRICK);

        assertThat(compilation.problems()).isEmpty();
        assertThat(compilation.classes()).containsOnlyKeys("Main", "robot/Eye");
    }

    @Test
    void whatTheBrickLacksIsAMistakeAtItsPlace() {
        String text = "class Main {\n  String s = String.format(\"%d\", 1);\n}\n";

        Compilation compilation =
                MemoryCompiler.compile(Map.of("Main.java", text), Map.of(), BRICK);

        assertThat(compilation.classes()).isEmpty();
        assertThat(compilation.problems())
                .containsExactly(
                        new Compilation.Problem(
                                "Main.java",
                                2,
                                text.indexOf("format"),
                                text.indexOf("format") + "format".length(),
                                "The method format(String, int) is undefined for the type String",
                                Optional.empty()));
    }

    @Test
    void theJdkIsOutOfReach() {
        Map<String, String> sources =
                Map.of(
                        "A.java", "class A { java.util.TreeMap map; }",
                        "B.java", "class B { java.text.Format format; }");

        assertThat(MemoryCompiler.compile(sources, Map.of(), BRICK).problems())
                .extracting(Compilation.Problem::message)
                .containsExactlyInAnyOrder(
                        "java.util.TreeMap cannot be resolved to a type",
                        "java.text cannot be resolved to a type");
    }
}
