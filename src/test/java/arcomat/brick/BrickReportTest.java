package arcomat.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.jar.RobotJar;
import arcomat.brick.jar.RobotJar.Origin;
import arcomat.brick.jar.RobotJar.RobotClass;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/** Counts and places of a report. */
class BrickReportTest {
    private static final String LOOP =
            """
            import lejos.nxt.*;
            import lejos.util.Delay;
            class Robot {
                public static void main(String[] arguments) {
                    UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S1);
                    LightSensor light = new LightSensor(SensorPort.S2);
                    long next = System.currentTimeMillis();
                    while (!Button.ESCAPE.isDown()) {
                        if (sonar.getDistance() < 20 || light.getLightValue() > 50) Motor.A.stop(true);
                        else Motor.B.forward();
                        next += 100;
                        Delay.msDelay(next - System.currentTimeMillis());
                    }
                    LCD.drawString("end", 0, 0);
                }
            }
            """;

    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    @Test
    void anEmptyProgramHasWhatTheLinkerKeepsBesideItsMainClass() {
        String empty = "class Robot { public static void main(String[] arguments) {} }";

        assertThat(linkedWithoutOwn(empty)).isEqualTo(74);
    }

    @Test
    void motorsUltrasonicAndLightBringWhatTheLinkerKeeps() {
        assertThat(linkedWithoutOwn(LOOP)).isEqualTo(98);
    }

    @Test
    void whatTheMachineThrowsByItselfCostsNothing() {
        String program = "class Robot { static void run() { throw new IllegalStateException(); } }";

        assertThat(linkedWithoutOwn(program)).isEqualTo(74);
    }

    @Test
    void anArrayOfObjectsThatIsMadeIsAClassAndOneOfStringsIsThereAnyway() {
        String program =
                "class Robot { Robot[] all; Robot[][] rows; int[] numbers;"
                        + " Object some = new String[3]; Object more = new String[3][4]; }";

        assertThat(linkedWithoutOwn(program)).isEqualTo(75);
    }

    private static int linkedWithoutOwn(String source) {
        BrickReport report = Robots.check(compiler.forBrick(source).orFail());
        return report.needs().classes() - report.classes();
    }

    @Test
    void classesAreCountedByOrigin() {
        byte[] small = compiler.forBrick("class Small { int i; }").orFail().get("Small");
        byte[] large = compiler.forBrick("class Large { void run() {} }").orFail().get("Large");
        RobotJar jar =
                new RobotJar(
                        "robot.jar",
                        List.of(
                                given("Small.class", small, Origin.HAND_WRITTEN),
                                given("Large.class", large, Origin.GENERATED),
                                given("Damaged.class", new byte[3], Origin.GENERATED)));

        BrickReport report = BrickCheck.check(jar, Robots.TABLE);

        assertThat(report.shares())
                .containsExactly(
                        new BrickReport.Share(Origin.GENERATED, 2, 2, large.length + 3),
                        new BrickReport.Share(Origin.HAND_WRITTEN, 1, 1, small.length));
        assertThat(report.classes()).isEqualTo(3);
        assertThat(report.bytes()).isEqualTo(small.length + large.length + 3);
        assertThat(report.fits()).isFalse();
    }

    @Test
    void withoutItsTextAClassIsNamedByItsEntryAndTheLineByTheMessage() {
        String program =
                """
                class Robot {
                    static int order(String text) {
                        return text.compareTo("b");
                    }
                }
                """;
        Map<String, byte[]> classes = compiler.forBrick(program).orFail();

        Diagnostic finding = Robots.check(classes).findings().get(0);

        assertThat(finding.span().file().path()).isEqualTo("robot.jar!/Robot.class");
        assertThat(finding.message()).startsWith("Robot.order (line 3) calls String.compareTo");
    }

    @Test
    void theClassesOfAJarAreReadFromItsBytes() throws IOException {
        Map<String, byte[]> classes = compiler.forBrick("class Robot { class Part {} }").orFail();
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ZipOutputStream zip = new ZipOutputStream(out)) {
            zip.putNextEntry(new ZipEntry("META-INF/MANIFEST.MF"));
            for (Map.Entry<String, byte[]> entry : classes.entrySet()) {
                zip.putNextEntry(new ZipEntry(entry.getKey() + ".class"));
                zip.write(entry.getValue());
            }
        }

        RobotJar jar =
                RobotJar.read(
                        "robot.jar",
                        out.toByteArray(),
                        name -> name.contains("$") ? Origin.GENERATED : Origin.RUNTIME);

        assertThat(BrickCheck.check(jar, Robots.TABLE).shares())
                .containsExactly(
                        new BrickReport.Share(
                                Origin.GENERATED, 1, 1, classes.get("Robot$Part").length),
                        new BrickReport.Share(Origin.RUNTIME, 1, 1, classes.get("Robot").length));
    }

    @Test
    void bytesThatAreNoJarHaveNoClasses() throws IOException {
        assertThat(RobotJar.read("robot.jar", new byte[10], name -> Origin.RUNTIME).classes())
                .isEmpty();
    }

    private static RobotClass given(String path, byte[] bytes, Origin origin) {
        return new RobotClass(path, bytes, origin, Optional.empty());
    }
}
