package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Robots of very many parts: one that fits, one whose slices take too long, one out of memory. */
class LargeRobotTest {
    private static final int ROW = 50;

    private static final String PART =
            """
            package p;

            component Part {
                timing instant;
                port <<total>> in Integer given, <<total>> out Integer told;

                automaton {
                    var Integer last, before;
                    state low, high;
                    initial low / {last = 0, before = 0};
                    low -> high [given > last + before] / {before = last, last = 3, told = last};
                    low [given <= last + before] / {told = given};
                    high -> low [given < last] / {before = last, last = 1, told = before};
                    high [given >= last] / {told = 7};
                }
            }
            """;

    @TempDir private Path folder;

    @Test
    void aFewPartsFit() throws Exception {
        assertThat(findings(100)).isEmpty();
    }

    @Test
    void athousandPartsTakeTooLong() throws Exception {
        assertThat(findings(1000))
                .singleElement()
                .matches(Diagnostic::isError)
                .satisfies(
                        each ->
                                assertThat(each.message())
                                        .matches(
                                                "a slice may take 1[1-7]\\d\\.\\d ms, but the next"
                                                        + " one is due after 100 ms; .*"));
    }

    @Test
    void twoThousandPartsNeedTooMuchMemory() throws Exception {
        assertThat(findings(2000))
                .anyMatch(
                        each ->
                                each.isError()
                                        && each.code().equals("ARC0917")
                                        && each.message().startsWith("the robot needs about ")
                                        && each.message().contains("but the brick has 49.0 kB"));
    }

    private List<Diagnostic> findings(int parts) throws IOException, WrongUse {
        Path models = folder.resolve("models");
        Files.createDirectories(models.resolve("p"));
        Files.writeString(models.resolve("p/Part.arc"), PART);
        Files.writeString(models.resolve("p/Row.arc"), chain("Row", "Part", ROW, ""));
        Files.writeString(
                models.resolve("p/Large.arc"), chain("Large", "Row", parts / ROW, "<<deploy>> "));
        GenerateCode task =
                new GenerateCode(
                        "lejos",
                        folder.resolve("out").toString(),
                        Optional.of("p.Large"),
                        false,
                        List.of(),
                        List.of(models.toString()));
        return Session.in(Path.of(""), Progress.NONE).run(task).check().findings();
    }

    /** Parts in a row, each of which hears what the one before it tells. */
    private static String chain(String name, String part, int number, String stereotype) {
        StringBuilder text =
                new StringBuilder("package p;\n\n")
                        .append(stereotype)
                        .append("component ")
                        .append(name)
                        .append(" {\n    timing instant;\n");
        boolean isOpen = stereotype.isEmpty();
        if (isOpen) {
            text.append("    port <<total>> in Integer given, <<total>> out Integer told;\n");
        }
        for (int i = 0; i < number; i++) {
            text.append("    component ").append(part).append(" part").append(i).append(";\n");
        }
        if (isOpen) {
            text.append("    connect given -> part0.given;\n");
            text.append("    connect part").append(number - 1).append(".told -> told;\n");
        } else {
            text.append("    component nxt.LightSensor(nxt.Brick.SensorPort.S1, 0, 1023) light;\n");
            text.append("    component nxt.RegulatedMotor(nxt.Brick.MotorPort.A) motor;\n");
            text.append("    connect light.value -> part0.given;\n");
            text.append("    connect part").append(number - 1).append(".told -> motor.speed;\n");
        }
        for (int i = 1; i < number; i++) {
            text.append("    connect part%d.told -> part%d.given;\n".formatted(i - 1, i));
        }
        return text.append("}\n").toString();
    }
}
