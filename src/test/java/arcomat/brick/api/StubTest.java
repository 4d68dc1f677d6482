package arcomat.brick.api;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickCompiler;
import arcomat.pipeline.FourZones;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.util.Textifier;
import org.objectweb.asm.util.TraceClassVisitor;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** A compiler that sees the stubs accepts what the brick has and refuses what it lacks. */
class StubTest {
    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    @Test
    void aRobotProgramCompiles() {
        compiler.forBrick(
                        """
                        import lejos.nxt.*;
                        import lejos.util.Delay;
                        import java.util.*;

                        public class Robot {
                            enum Mode { DRIVING, WAITING }

                            public static void main(String[] args) throws Exception {
                                UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S1);
                                LightSensor light = new LightSensor(SensorPort.S2);
                                Mode mode = Mode.DRIVING;
                                Map<Mode, Integer> seen = new HashMap<Mode, Integer>();
                                List<String> lines = new ArrayList<String>();
                                long next = System.currentTimeMillis();
                                while (!Button.ESCAPE.isDown()) {
                                    int value = light.getLightValue();
                                    switch (mode) {
                                        case DRIVING: mode = sonar.getDistance() < 20 ? Mode.WAITING : mode; break;
                                        case WAITING: Motor.A.stop(true); break;
                                    }
                                    seen.put(mode, value);
                                    for (Map.Entry<Mode, Integer> entry : seen.entrySet()) {
                                        lines.add(entry.getKey().name() + "=" + entry.getValue());
                                    }
                                    for (String line : lines) LCD.drawString(line, 0, 0);
                                    next += 100;
                                    Delay.msDelay(Math.max(0, next - System.currentTimeMillis()));
                                }
                                Thread guard = new Thread() {
                                    @Override public void run() { Motor.B.flt(true); }
                                };
                                guard.start();
                                synchronized (guard) { guard.notifyAll(); }
                            }
                        }
                        """)
                .orFail();
    }

    @ParameterizedTest(name = "{1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '`',
            value = {
                "String s = String.format(\"%d\", 1);           | format(String, int) is undefined",
                "boolean b = \"ab\".contains(\"b\");             | contains(String) is undefined",
                "String[] parts = \"a,b\".split(\",\");          | split(String) is undefined",
                "Object o = new java.util.TreeMap();             | java.util.TreeMap cannot be"
                        + " resolved",
                "Object o = java.util.Objects.hash(1);           | java.util.Objects cannot be"
                        + " resolved",
                "Object o = new lejos.nxt.Motor();               | constructor Motor() is"
                        + " undefined",
                "int i = lejos.nxt.SensorPort.S5.readValue();    | S5 cannot be resolved",
                "Object o = int.class.getMethods();              | getMethods() is undefined",
                "Runnable r = () -> {};                          | Lambda expressions are allowed"
                        + " only",
                "Object o = new Throwable() { @Override public StackTraceElement[] getStackTrace()"
                        + " { return null; } }; | StackTraceElement cannot be resolved",
                "Object o = new Thread() { @Override public void destroy() { } };"
                        + " | must override or implement a supertype method",
                "throw new ArithmeticException();        | Unhandled exception type"
                        + " ArithmeticException",
                "Thread.sleep(1);                        | Unhandled exception type"
                        + " InterruptedException",
            })
    void whatTheBrickLacksIsRefused(String statement, String message) {
        String program = "public class Bad { static void run() { %s } }".formatted(statement);

        assertThat(compiler.forBrick(program).messages()).contains(message);
    }

    @Test
    void anUncheckedExceptionNeedsNoClause() {
        compiler.forBrick("class Fine { void run() { throw new IllegalStateException(); } }")
                .orFail();
    }

    @Test
    void constantsAreCopiedToWhereTheyAreRead() {
        String program =
                """
                public class Constants {
                    static final byte MODE = lejos.nxt.UltrasonicSensor.MODE_PING;
                    static int pick(int mode) {
                        switch (mode) { case lejos.nxt.SensorPort.SP_MODE_ADC: return Integer.MAX_VALUE; }
                        return mode;
                    }
                    static double half() { return Math.PI / 2; }
                    static long ages() { return Long.MIN_VALUE; }
                    static float none() { return Float.NaN; }
                    static char last() { return Character.MAX_VALUE; }
                }
                """;

        String code = text(compiler.forBrick(program).orFail().get("Constants"));

        assertThat(code)
                .doesNotContain("GETSTATIC")
                .contains("MODE = 1", "3: L", "LDC 2147483647", "LDC 1.5707963267948966")
                .contains("LDC -9223372036854775808L", "LDC NaNF", "LDC 65535");
    }

    @Test
    void annotationsForTheCompilerLeaveNoTrace() {
        String program = "class Quiet { @Override public String toString() { return null; } }";

        assertThat(text(compiler.forBrick(program).orFail().get("Quiet")))
                .doesNotContain("Override");
    }

    @Test
    void anAnnotationOfTheBrickIsOne() {
        compiler.forBrick("class Old { @Deprecated @SuppressWarnings(\"all\") void run() {} }")
                .orFail();
    }

    @Test
    void theJarIsTheSameEveryTimeAndInEveryTimeZone() throws Exception {
        List<byte[]> jars = FourZones.each(StubTest::jar);
        assertThat(jars).containsOnly(jars.get(0));
    }

    private static byte[] jar() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        StubJar.write(BrickTable.leJos(), out);
        return out.toByteArray();
    }

    private static String text(byte[] classFile) {
        java.io.StringWriter text = new java.io.StringWriter();
        new ClassReader(classFile)
                .accept(
                        new TraceClassVisitor(null, new Textifier(), new java.io.PrintWriter(text)),
                        0);
        return text.toString();
    }
}
