package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.stream.Stream;

/**
 * A brick that takes over the classes of an earlier one runs as one for which they were loaded:
 * what is static begins anew, at the same moments and in the same order.
 */
class RepetitionTest {
    private static final Path PROGRAMS = Path.of("src/test/programs");
    private static final long LIMIT = 60_000;
    private static final int OFTEN = 20;

    /** All that can be seen of a run, as text. */
    private static String run(LoadedProgram program, Script script, Limits limits) {
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick brick = laboratory.place("brick", program);
            brick.observe(recorder);
            brick.play(script);
            laboratory.runToEnd(LIMIT);
            return "%s%d %s %s %s"
                    .formatted(
                            TraceText.of(recorder.trace()),
                            laboratory.time(),
                            brick.outcome().kind(),
                            brick.outcome().failure(),
                            brick.screen());
        }
    }

    private static Script script(String text) {
        return ScriptParser.parse(text).script().orElseThrow();
    }

    private static void check(Program program, Script script, boolean repeats) {
        for (Limits limits : List.of(Limits.OF_THE_BRICK, Limits.NONE)) {
            String fresh = run(LoadedProgram.forOnce(program), script, limits);
            LoadedProgram again = LoadedProgram.forMany(program);
            assertThat(again.repeats(limits.counted())).isEqualTo(repeats);
            for (int i = 0; i < OFTEN; i++) {
                assertThat(run(again, script, limits)).as("run %d", i).isEqualTo(fresh);
            }
        }
    }

    @TestFactory
    Stream<DynamicTest> programsOfTheFolderDoTheSameAgain() throws IOException {
        try (Stream<Path> files = Files.list(PROGRAMS)) {
            return files
                    .map(file -> file.getFileName().toString())
                    .filter(file -> file.endsWith(".script"))
                    .map(file -> file.replace(".script", ""))
                    .sorted()
                    .toList()
                    .stream()
                    .map(name -> DynamicTest.dynamicTest(name, () -> checkFile(name)));
        }
    }

    private static void checkFile(String name) throws IOException {
        Script script = script(Files.readString(PROGRAMS.resolve(name + ".script")));
        LoadedProgram program = LoadedProgram.forMany(Compiled.file(name));
        check(program.program(), script, program.repeats(true));
    }

    private static final Program ORDER =
            Compiled.source(
                    "Order",
                    """
                    import lejos.nxt.*;
                    public class Order {
                        static int row;
                        static int say(String text) {
                            LCD.drawString(text + System.currentTimeMillis(), 0, row++);
                            lejos.util.Delay.msDelay(7);
                            return row;
                        }
                        static class Above { static final int A = say("above "); }
                        static class Below extends Above {
                            static final String WORD = "word";
                            static Object first = new Object();
                            static final int B = say("below ");
                            static int use() { return A; }
                        }
                        static class Twin { static final Twin ONE = new Twin(); int n = say("twin "); }
                        static class Circle { static int c = 1 + Twice.d; }
                        static class Twice { static int d = 1 + Circle.c; }
                        public static void main(String[] args) {
                            say(Below.WORD + " ");
                            say("use " + Below.use() + " ");
                            say("twin " + Twin.ONE.n + " ");
                            say(Circle.c + " " + Twice.d + " ");
                            Below.first = null;
                            Button.setKeyClickVolume(3);
                            Motor.A.setSpeed(77);
                            Motor.A.rotate(30);
                        }
                    }
                    """);

    @Test
    void classesBeginWhenTheyAreNeededAndThoseAboveThemFirst() {
        check(ORDER, script(""), true);
        String run = run(LoadedProgram.forOnce(ORDER), script(""), Limits.NONE);
        assertThat(run).contains("[word 0, above", "below", "twin", "2 1");
    }

    /** What Java says of a class that failed to begin, at first and later. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "int x = Bad.value;",
                "try { new Bad(); } catch (Throwable e) { say(e); } say(Good.TEXT); new Bad();",
                "try { Worse.go(); } catch (Throwable e) { say(e); } Worse.go();",
                "try { new Heir(); } catch (Throwable e) { say(e); } new Bad();",
                "try { new Heir(); } catch (Throwable e) { say(e); } new Heir();",
                "try { new Fat(); } catch (Throwable e) { say(e); } Fat.more();",
            })
    void aClassThatFailsToBeginFailsAgain(String body) {
        Program program =
                Compiled.source(
                        "Fail",
                        """
                        import lejos.nxt.*;
                        public class Fail {
                            static void say(Object text) { LCD.drawString("" + text, 0, 1); }
                            static class Bad {
                                static int value = Integer.parseInt("x");
                            }
                            static class Heir extends Bad { static int more = 2; }
                            static class Worse {
                                static { if (LCD.SCREEN_WIDTH > 0) throw new OutOfMemoryError(); }
                                static void go() {}
                            }
                            static class Fat {
                                static byte[] much = new byte[1000000];
                                static void more() { say("more"); }
                            }
                            static class Good { static String TEXT = "good".substring(1); }
                            public static void main(String[] args) {
                                %s
                            }
                        }
                        """
                                .formatted(body));
        check(program, script(""), true);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "enum Color { RED }",
                "interface Named { Object NAME = new Object(); }",
                "static class Late { protected void finalize() {} }",
                "static Runnable action() { return Refused::new; }",
                "static Object made() throws Exception { return Refused.class.newInstance(); }",
            })
    void whatCannotBeginAgainIsLoadedAnew(String member) {
        Program program =
                Compiled.source(
                        "Refused",
                        """
                        public class Refused {
                            static int count;
                            %s
                            public static void main(String[] args) {
                                lejos.nxt.LCD.drawInt(++count, 0, 0);
                            }
                        }
                        """
                                .formatted(member));
        LoadedProgram again = LoadedProgram.forMany(program);
        boolean own = member.contains("Runnable"); // a method of the class itself
        check(program, script(""), own);
        assertThat(again.repeats(true)).isEqualTo(own);
    }

    /**
     * A program that was stopped in the middle leaves nothing behind, and one that fails neither.
     */
    @Test
    void aProgramThatIsStoppedLeavesNothingBehind() {
        Program program =
                Compiled.source(
                        "Endless",
                        """
                        import lejos.nxt.*;
                        public class Endless extends Thread {
                            static int count;
                            static final Object LOCK = new Object();
                            public void run() { synchronized (LOCK) { while (true) count++; } }
                            public static void main(String[] args) throws Exception {
                                new Endless().start();
                                Motor.B.forward();
                                try {
                                    while (true) {
                                        LCD.drawInt(count, 0, 0);
                                        Thread.sleep(50);
                                        Button.LEFT.addButtonListener(new ButtonListener() {
                                            public void buttonPressed(Button b) { count = -1000; }
                                            public void buttonReleased(Button b) { }
                                        });
                                    }
                                } finally {
                                    count = 5;
                                }
                            }
                        }
                        """);
        check(program, script("100 button LEFT\n300 end\n"), true);
    }

    @Test
    void threadsOfThePcMayRunItAtTheSameTime() throws Exception {
        LoadedProgram program = LoadedProgram.forMany(ORDER);
        String fresh = run(LoadedProgram.forOnce(ORDER), script(""), Limits.OF_THE_BRICK);
        Callable<String> one = () -> run(program, script(""), Limits.OF_THE_BRICK);
        ExecutorService threads = Executors.newFixedThreadPool(3);
        List<Future<String>> runs = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            runs.add(threads.submit(one));
        }
        for (Future<String> run : runs) {
            assertThat(run.get()).isEqualTo(fresh);
        }
        threads.shutdown();
    }
}
