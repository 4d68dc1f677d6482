package arcomat.brick.need;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.BrickCompiler;
import arcomat.brick.api.BrickTable;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.tree.ClassNode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Predictions for small programs, with the runtime's loop of slices and without. */
class NeedsTest {
    private static final BrickTable TABLE = BrickTable.leJos();
    private static final Path NXT = Path.of("lejos-runtime/nxt/src/main/java");
    private static final Path RT = Path.of("lejos-runtime/rt/src/main/java");

    @TempDir static Path folder;
    private static BrickCompiler compiler;

    @BeforeAll
    static void writeStubJar() {
        compiler = new BrickCompiler(folder);
    }

    private static Needs needs(String... members) throws IOException {
        return program(
                "public class Bot extends arcomat.nxt.Robot {"
                        + " public static void main(String[] args) { new Bot().run(50); }"
                        + String.join(" ", members)
                        + " }");
    }

    private static Needs program(String text) throws IOException {
        List<SourceFile> sources = new ArrayList<>();
        sources.add(new SourceFile("Bot.java", text));
        sources.add(source(NXT, "arcomat/nxt/Robot.java"));
        sources.add(source(NXT, "arcomat/nxt/Row.java"));
        sources.add(source(NXT, "arcomat/nxt/Shaft.java"));
        sources.add(source(RT, "arcomat/rt/Cycle.java"));
        Map<String, byte[]> classes =
                compiler.forBrick(sources.toArray(new SourceFile[0])).orFail();
        return Needs.of(classes.values().stream().map(NeedsTest::node).toList(), TABLE);
    }

    private static SourceFile source(Path root, String path) throws IOException {
        return new SourceFile(path, Files.readString(root.resolve(path)));
    }

    private static ClassNode node(byte[] bytes) {
        ClassNode node = new ClassNode();
        new ClassReader(bytes).accept(node, ClassReader.SKIP_FRAMES);
        return node;
    }

    /** The time of a slice beyond that of an empty one. */
    private static long time(String slice, String... members) throws IOException {
        return time(needs(robot(slice, members))) - time(needs(robot("")));
    }

    private static long time(Needs needs) {
        assertThat(needs.slice().unknown()).isEmpty();
        return needs.slice().amount().orElseThrow();
    }

    /** A robot with a number of which nothing is known, since another thread may write it. */
    private static String robot(String slice, String... members) {
        return "int n; static class Ear implements lejos.nxt.ButtonListener { Bot bot; public void"
                + " buttonPressed(lejos.nxt.Button key) { bot.n++; } public void"
                + " buttonReleased(lejos.nxt.Button key) {} }"
                + " protected void start() {} protected void slice() { "
                + slice
                + " } "
                + String.join(" ", members);
    }

    @Test
    void anInstructionTakesTwoMicrosecondsAndACallEight() throws IOException {
        // aload, aload, getfield, iconst, iadd, putfield; an empty method returns, that is one more
        assertThat(time("n = n + 1;")).isEqualTo(6 * 2);
        assertThat(time("work();", "static void work() {}")).isEqualTo(8 + 2);
    }

    @Test
    void ofBranchesTheLongerOneCounts() throws IOException {
        long work = time("work();", "static void work() {}");
        String empty = "static void work() {}";
        long both = time("if (n > 0) work(); else { work(); work(); work(); }", empty);

        assertThat(both).isBetween(3 * work, 3 * work + 8);
        assertThat(time("switch (n) { case 1: work(); break; case 2: work(); work(); }", empty))
                .isBetween(2 * work, 2 * work + 8);
    }

    @Test
    void ofClassesThatMayBeMeantTheLongestCounts() throws IOException {
        String classes =
                "static abstract class A { abstract void work(int n); } static class Short extends"
                    + " A { void work(int n) { n++; } } static class Longer extends Short { void"
                    + " work(int n) { n = n * n * n * n * n * n + 3 * n; } } static A a; A"
                    + " made(boolean first) { return first ? new Short() : new Longer(); }";
        String shorter = "((Short) a).work(n);";
        long one = time("Longer l = (Longer) a; l.work(n);", classes);

        assertThat(time("a.work(n);", classes)).isGreaterThan(one - 8);
        assertThat(time("Short s = (Short) a; s.work(n);", classes)).isEqualTo(one);
        assertThat(time(shorter, classes)).isGreaterThan(one - 8);
    }

    /** As far as the slices from the start on can be told; n is what nobody knows. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "if (n == 1) work(); if (n == 2) work(); # 2",
                "m = n; if (m == 1) work(); if (m == 2) work(); # 2",
                "if (m == 1) work(); else m = 1; if (m == 2) work(); # 1",
                "if (m == 0) work(); if (k == 1) work(); m = 1; k = 1; # 1",
                "if (m < 5) m++; if (m == 3) work(); if (m == 5) work(); # 1",
                "m++; if (m == 3) work(); if (m == 5) work(); # 2",
                "if (n > 0) m = 1; else m = 2; if (m == 1) work(); if (m == 2) work(); # 1",
                "switch (m) { case 0: m = 7; break; case 7: work(); case 9: work(); } # 2",
                "switch (m) { case 0: m = 7; work(); break; case 8: work(); work(); } # 1",
                "one.turn(); if (one.on) work(); if (!one.on) work(); # 1",
                "one.turn(); if (one.on) work(); if (other.on) work(); # 1",
                "all[n].turn(); if (one.on) work(); if (other.on) work(); # 2",
                "heard.turn(); if (heard.on) work(); if (one.on) work(); # 1",
                "lamp().turn(); if (one.on) work(); if (other.on) work(); # 2",
                "if (one == other) work(); if (one != null) work(); # 1"
            })
    void branchesThatNeverComeTogetherDoNotCountTogether(String slice, long works)
            throws IOException {
        String work = "static void work() { for (int i = 0; i < 100; i++) {} }";
        String lamps =
                "int m, k; static class Lamp { boolean on; void turn() { on = !on; } } Lamp lamp()"
                    + " { return n > 0 ? one : other; } Lamp one = new Lamp(), other = new Lamp(),"
                    + " heard = new Lamp(); Lamp[] all = {one, other};";
        long one = time("work();", work);

        assertThat(time(slice, work, lamps)).isBetween(works * one, works * one + one / 2);
    }

    @Test
    void aLoopCountsAsOftenAsItGoesRound() throws IOException {
        long ten = time("for (int i = 0; i < 10; i++) n++;");
        long twenty = time("for (int i = 0; i < 20; i++) n++;");
        long nested = time("for (int i = 0; i < 10; i++) { for (int k = 0; k < 10; k++) n++; }");

        assertThat(twenty - ten).isEqualTo(10 * 10 * 2);
        assertThat(nested).isBetween(10 * ten, 11 * ten);
    }

    @Test
    void whatEndsTheSliceDoesNotCount() throws IOException {
        String fail =
                "void fail(int n) { for (int i = 0; i < n; i++) n--; throw new RuntimeException();"
                        + " }";

        assertThat(time("if (n > 0) throw new RuntimeException(\"\" + n);")).isLessThan(8);
        assertThat(time("if (n > 0) fail(n);", fail)).isLessThan(8);
    }

    @Test
    void motorsThatTurnTakeTheirShare() throws IOException {
        String shafts = "void made() { }";
        String one =
                robot("n++; ", shafts).replace("start() {", "start() { new arcomat.nxt.Shaft(1);");
        String three =
                robot("n++;", "lejos.nxt.NXTRegulatedMotor a() { return lejos.nxt.Motor.A; }")
                        .replace(
                                "start() {",
                                "start() { new arcomat.nxt.Shaft(2); new arcomat.nxt.Shaft(3);"
                                        + " new arcomat.nxt.Shaft(1);");
        long none = time(needs(robot("n++;")));

        assertThat(time(needs(one))).isBetween(none * 4000 / 3400 - 1, none * 4000 / 3400 + 1);
        assertThat(time(needs(three))).isGreaterThan(none * 3 / 2).isLessThan(none * 2);
    }

    /** Regulation takes its share of what computes; of a wait, only what runs at its end counts. */
    @Test
    void aWaitForABusIsHardlyLongerWhileMotorsTurn() throws IOException {
        String sonar = "static lejos.nxt.UltrasonicSensor sonar;";
        long wait = 4600;
        long computing = time("sonar.getDistance();", sonar) - wait;
        long turning =
                time(needs(turning("sonar.getDistance();", sonar)))
                        - time(needs(turning("", sonar)));
        long expected = wait + 600 + computing * 4000 / 3400;

        assertThat(computing).isPositive();
        assertThat(turning).isBetween(expected - 1, expected + 1);
    }

    private static String turning(String slice, String members) {
        return robot(slice, members).replace("start() {", "start() { new arcomat.nxt.Shaft(1);");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "while (n > 0) n--; # a loop may go round any number of times in Bot.slice",
                "for (int i = 0; i < n; i++) n--; # a loop may go round any number of times in"
                        + " Bot.slice",
                "work(3); # Bot.work calls itself",
                "lejos.nxt.Motor.A.rotate(90); # lejos.nxt.NXTRegulatedMotor.rotate may wait",
                "lejos.nxt.Motor.A.stop(); # lejos.nxt.NXTRegulatedMotor.stop may wait",
                "lejos.util.Delay.msDelay(2); # lejos.util.Delay.msDelay may wait",
                "new Thread() { public void run() {} }.start(); # Bot$1 is a thread that runs"
                        + " meanwhile"
            })
    void whatCannotBeToldIsNotGuessed(String slice, String why) throws IOException {
        String work = "void work(int n) { if (n > 0) work(n - 1); }";
        Needs needs = needs(robot(slice, work));

        assertThat(needs.slice().amount()).isEmpty();
        assertThat(needs.slice().unknown()).hasValue(why);
        assertThat(needs.cycle()).hasValue(50);
    }

    @Test
    void aLoopOfItsOwnHasNoSlices() throws IOException {
        Needs needs =
                program(
                        "class Bot { public static void main(String[] args) {"
                                + " while (!lejos.nxt.Button.ESCAPE.isDown())"
                                + " lejos.nxt.Motor.A.forward(); } }");

        assertThat(needs.slice().unknown()).hasValue("the program has a loop of its own");
        assertThat(needs.memory().amount()).isPresent();
        assertThat(needs.cycle()).isEmpty();
    }

    @Test
    void withoutAMainMethodThereIsNothingToFollow() throws IOException {
        Needs needs = program("class Bot { }");

        assertThat(needs.slice().unknown()).hasValue("the jar has no main method");
        assertThat(needs.memory().unknown()).hasValue("the jar has no main method");
    }

    /** The memory that a start takes beyond that of an empty one. */
    private static long memory(String start, String... members) throws IOException {
        return memory(needs(robot("", members).replace("start() {", "start() {" + start)))
                - memory(needs(robot("", members)));
    }

    private static long memory(Needs needs) {
        assertThat(needs.memory().unknown()).isEmpty();
        return needs.memory().amount().orElseThrow();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "new Object(); # 4",
                "new Fields(); # 28", // 4 + 1 + 1 + 2 + 4 + 8 + 4 + 4
                "new More(); # 32",
                "byte[] a = new byte[5]; # 12",
                "int[] a = new int[5]; # 24",
                "long[] a = new long[300]; # 2408",
                "Object[] a = new Object[5]; # 24",
                "int[][] a = new int[3][5]; # 88",
                "for (int i = 0; i < 10; i++) new Object(); # 40",
                "for (int i = 0; i < n; i++) n++; # 0",
                "if (n > 0) new Object(); else new Fields(); # 28",
                "if (n > 0) throw new RuntimeException(\"not\" + n); # 0",
                "named = \"four\"; # 20",
                "Enum[] all = Kind.values(); # 16"
            })
    void objectsTakeTheirFieldsAndAWord(String start, long bytes) throws IOException {
        String classes =
                "String named; enum Kind { A, B, C } static class Fields { boolean a; byte b; char"
                    + " c; int d; long e; Object f; float g; static final int H = 1; } static class"
                    + " More extends Fields { byte h; }";
        long growingStacks = 60;

        assertThat(memory(start, classes)).isBetween(bytes, bytes + growingStacks);
        assertThat((memory(start, classes) - bytes) % 20).isZero();
    }

    @Test
    void whatASliceMakesMayStay() throws IOException {
        long made = memory(needs(robot("new long[100].clone();"))) - memory(needs(robot("")));

        assertThat(made).isBetween(804L, 870L);
    }

    /** As programs that are driven by events do: however many wait, none of them makes anything. */
    @Test
    void aSliceThatGoesOnUntilNothingWaitsMakesNothing() throws IOException {
        String react =
                "boolean react() { if (n == 0) return false; n--; note(\"some port\"); return true;"
                        + " } void note(String text) {}";
        long made = memory(needs(robot("while (react()) {}", react))) - memory(needs(robot("")));

        assertThat(made).isBetween(0L, 120L);
        assertThat(needs(robot("while (react()) { new Object(); }", react)).memory().unknown())
                .hasValue("a loop may go round any number of times in Bot.slice");
    }

    @Test
    void aListenerHasAThreadWithAStack() throws IOException {
        String listener =
                "static class Ears implements lejos.nxt.ButtonListener { public void"
                        + " buttonPressed(lejos.nxt.Button key) { %s } public void"
                        + " buttonReleased(lejos.nxt.Button key) {} }";
        long none = memory(needs(robot("", "static class Ears {}")));
        long idle = memory(needs(robot("", listener.formatted("")))) - none;
        long made = memory(needs(robot("", listener.formatted("new long[10].clone();")))) - none;

        assertThat(idle).isBetween(52L + 12 + 20, 52L + 12 + 100 + 100);
        assertThat(made - idle).isBetween(84L, 84L + 6 * 20 + 40 * 4 + 20);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '#',
            value = {
                "while (n > 0) new Object(); # a loop may go round any number of times in"
                        + " Bot.start",
                "Object a = new int[n]; # the length of an array is not written as a number in"
                        + " Bot.start",
                "work(3); # Bot.work calls itself"
            })
    void memoryThatCannotBeToldIsNotGuessed(String start, String why) throws IOException {
        String work = "void work(int n) { if (n > 0) work(n - 1); }";
        Needs needs = needs(robot("", work).replace("start() {", "start() {" + start));

        assertThat(needs.memory().unknown()).hasValue(why);
    }

    @Test
    void whereAClassIsNowhereTheNumberIsAnEstimate() throws IOException {
        String text =
                "public class Bot { static class Lost {}"
                        + " public static void main(String[] args) { new Lost(); } }";
        Map<String, byte[]> classes = compiler.forBrick(new SourceFile("Bot.java", text)).orFail();
        Needs all = Needs.of(classes.values().stream().map(NeedsTest::node).toList(), TABLE);
        Needs less = Needs.of(List.of(node(classes.get("Bot"))), TABLE);

        assertThat(needs(robot("new StringBuffer();")).isExact()).isTrue();
        assertThat(all.isExact()).isTrue();
        assertThat(less.isExact()).isFalse();
        assertThat(less.classes()).isEqualTo(all.classes());
    }

    /** The numbers are those of the linker of leJOS NXJ 0.9.1. */
    @ParameterizedTest
    @CsvSource({
        "Behaviors, 101",
        "Bumper, 105",
        "Buttons, 75",
        "Echoes, 83",
        "Light, 86",
        "Listeners, 108",
        "Locks, 76",
        "Motors, 93",
        "Senses, 91",
        "Survivor, 77",
        "Threads, 78"
    })
    void classesAreThoseThatTheLinkerKeeps(String name, int classes) throws IOException {
        Path programs = Path.of("lejos-runtime/sim/src/test/programs");
        Map<String, byte[]> compiled = compiler.forBrick(source(programs, name + ".java")).orFail();
        Needs needs = Needs.of(compiled.values().stream().map(NeedsTest::node).toList(), TABLE);

        assertThat(needs.isExact()).isTrue();
        assertThat(needs.classes()).isEqualTo(classes);
    }

    @Test
    void whatNobodyCallsIsNotLinked() throws IOException {
        Needs none = needs(robot(""));
        Needs unused =
                needs(
                        robot(
                                "",
                                "static class Unused {}"
                                        + " interface Named {} Named named; Unused[] field;"
                                        + " void never() { new Unused(); }"));

        assertThat(unused.classes()).isEqualTo(none.classes());
        assertThat(unused.isExact()).isTrue();
    }

    @Test
    void whatOverridesIsLinkedWhereItIsMadeAndCalled() throws IOException {
        String classes =
                "static class A { void work() {} }"
                        + " static class B extends A { void work() { new C(); } }"
                        + " static class C {}";
        int both = needs(robot("new B(); new A().work();", classes)).classes();
        int one = needs(robot("new A().work();", classes)).classes();
        int none = needs(robot("", classes)).classes();

        assertThat(needs(robot("int[][] a = new int[2][3];", classes)).classes())
                .isEqualTo(none + 1);
        assertThat(needs(robot("a(); } static void a() { A[] a = new A[2];", classes)).classes())
                .isEqualTo(none + 2);
        assertThat(one).isEqualTo(none + 1);
        assertThat(both).isEqualTo(none + 3);
    }
}
