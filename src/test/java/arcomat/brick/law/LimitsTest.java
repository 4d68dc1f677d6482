package arcomat.brick.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import arcomat.brick.BrickCompiler;
import arcomat.brick.Robots;
import arcomat.source.Diagnostic;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.nio.file.Path;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.function.IntFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** What just fits is fine, one more is refused. */
class LimitsTest {
    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    @Test
    void methods() {
        IntFunction<String> methods =
                n -> "class Robot { Robot() {} " + each(n, "void m%d() {}") + "}";

        assertThat(findings(methods.apply(254))).isEmpty();
        assertThat(findings(methods.apply(255)))
                .isEqualTo(
                        "ARC0905 Robot has 256 methods, but the brick has room for 255; divide it"
                                + " into several classes");
    }

    @Test
    void fields() {
        IntFunction<String> fields =
                n -> "class Robot { static int other; " + each(n, "int f%d;") + "}";

        assertThat(findings(fields.apply(255))).isEmpty();
        assertThat(findings(fields.apply(256)))
                .isEqualTo(
                        "ARC0906 Robot has 256 fields, but the brick has room for 255; divide it"
                                + " into several classes");
    }

    @Test
    void locals() {
        IntFunction<String> locals =
                n ->
                        "class Robot { static int sum; static void run() { "
                                + each(n, "int v%d = sum;")
                                + each(n, "sum += v%d;")
                                + "} }";

        assertThat(findings(locals.apply(255))).isEmpty();
        assertThat(findings(locals.apply(256)))
                .isEqualTo(
                        "ARC0907 Robot.run has 256 words of local variables, but the brick has room"
                                + " for 255; divide it into several methods");
    }

    @Test
    void parameters() {
        String fits =
                "class Robot { static void run(long a, long b, long c, long d, long e, long f,"
                        + " long g, double h) {} void walk("
                        + commas(15, "int v%d")
                        + ") {} }";
        String manyWords =
                "class Robot { void run(long a, long b, long c, long d, long e, long f, long g,"
                        + " double h) {} }";
        String manyInts = "class Robot { static void run(" + commas(17, "int v%d") + ") {} }";

        assertThat(findings(fits)).isEmpty();
        assertThat(findings(manyWords) + "\n" + findings(manyInts))
                .isEqualTo(
                        """
                        ARC0908 Robot.run has 17 parameter words, but the brick has room for 16; pass an object or use fields
                        ARC0908 Robot.run has 17 parameter words, but the brick has room for 16; pass an object or use fields\
                        """);
    }

    @Test
    void constants() {
        IntFunction<String> constants =
                n ->
                        "class Robot { static int run() { int v = 0; "
                                + each(n, "v += 4%05d;")
                                + " v += 400000; v += 400000; return v + 5; } }";

        assertThat(findings(constants.apply(1024))).isEmpty();
        assertThat(findings(constants.apply(1025)))
                .isEqualTo(
                        "ARC0909 the robot has 1025 different constants, but the brick has room for"
                                + " 1024; use fewer texts and large numbers");
    }

    @Test
    void staticFields() {
        IntFunction<String> fields =
                n ->
                        "class Robot { static final int CONSTANT = 1; "
                                + each(n, "static int f%d;")
                                + "}";

        assertThat(findings(fields.apply(1024))).isEmpty();
        assertThat(findings(fields.apply(1025)))
                .isEqualTo(
                        "ARC0910 the robot has 1025 static fields, but the brick has room for 1024;"
                                + " use fields of objects, or constants");
    }

    @Test
    void classes() {
        IntFunction<String> classes =
                n -> "class Robot { " + each(n - 1, "static class C%d {}") + "}";
        String near =
                "ARC0912 linked, the robot has %d classes, and the brick has room for"
                        + " 256; use fewer of leJOS' classes or fewer components";

        assertThat(findings(classes.apply(130))).isEmpty();
        assertThat(findings(classes.apply(131))).isEqualTo(near.formatted(205));
        assertThat(findings(classes.apply(182))).isEqualTo(near.formatted(256));
        assertThat(findings(classes.apply(183)))
                .isEqualTo(
                        "ARC0911 the robot has 183 classes, but the brick has room for 182; use"
                                + " fewer components, or spread them over two bricks");
    }

    @Test
    void classFileVersions() {
        Map<String, byte[]> classes = compiler.forBrick("class Robot {}").orFail();
        byte[] bytes = classes.get("Robot");

        assertThat(findings(withVersion(bytes, 49)) + findings(withVersion(bytes, 61))).isEmpty();
        assertThat(findings(withVersion(bytes, 48)))
                .isEqualTo(
                        "ARC0901 Robot is a class file of version 48; the brick's linker reads 49"
                                + " to 61: compile it for Java 6");
        assertThat(findings(withVersion(bytes, 62)))
                .isEqualTo(
                        "ARC0901 Robot is a class file of version 62, Java 18; the brick's linker"
                                + " reads 49 to 61: compile it for Java 6");
        assertThat(findings(withVersion(bytes, 9999)))
                .isEqualTo(
                        "ARC0901 Robot.class is a class file of version 9999, Java 9955; the"
                                + " brick's linker reads 49 to 61: compile it for Java 6");
    }

    @Test
    void filesThatAreNoClassFiles() {
        byte[] bytes = compiler.forBrick("class Robot { int i; }").orFail().get("Robot");
        String damaged = "ARC0901 Robot.class is not a class file, or a damaged one; make it anew";

        for (int length = 0; length < bytes.length; length += 7) {
            byte[] cut = java.util.Arrays.copyOf(bytes, length);
            assertThat(findings(Map.of("Robot", cut)))
                    .as("first %d bytes", length)
                    .isEqualTo(damaged);
        }
        assertThat(findings(Map.of("Robot", "public class Robot {}".getBytes())))
                .isEqualTo(damaged);
    }

    /** Whatever is wrong with a class file, it is a finding and never a failure. */
    @Tag("slow")
    @Test
    void anyDamageIsSurvived() {
        Map<String, byte[]> classes =
                compiler.forBrick(
                                """
                                class Robot extends Thread {
                                    enum Mode { ON, OFF }
                                    static final String[][] NAMES = new String[2][3];
                                    public void run() {
                                        try {
                                            switch (Mode.values()[0]) { case ON: join(); break; }
                                            long sum = 4000000000L + "a".compareTo(NAMES[0][0] + 1);
                                        } catch (InterruptedException e) {
                                            throw new IllegalStateException(String.class.toString());
                                        }
                                    }
                                }
                                """)
                        .orFail();
        Random random = new Random(7);

        for (int i = 0; i < 1000; i++) {
            Map<String, byte[]> damaged = new TreeMap<>(classes);
            damaged.replaceAll((name, bytes) -> damage(bytes, random));
            assertThatCode(() -> Robots.check(damaged))
                    .as("damage number %d", i)
                    .doesNotThrowAnyException();
        }
    }

    private static byte[] damage(byte[] bytes, Random random) {
        byte[] damaged = bytes.clone();
        damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
        return damaged;
    }

    private static Map<String, byte[]> withVersion(byte[] bytes, int version) {
        byte[] other = bytes.clone();
        other[6] = (byte) (version >> 8);
        other[7] = (byte) version;
        return Map.of("Robot", other);
    }

    private static String findings(String source) {
        return findings(compiler.forBrick(source).orFail());
    }

    private static String findings(Map<String, byte[]> classes) {
        return Robots.check(classes).findings().stream()
                .map(LimitsTest::text)
                .collect(Collectors.joining("\n"));
    }

    private static String text(Diagnostic finding) {
        return finding.code() + " " + finding.message();
    }

    private static String each(int number, String form) {
        return IntStream.range(0, number)
                .mapToObj(form::formatted)
                .collect(Collectors.joining(" "));
    }

    private static String commas(int number, String form) {
        return each(number, form + ",").replaceFirst(",$", "");
    }
}
