package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * A program of the form that the tool makes rests between its slices, and does what it does on
 * threads of its own; one of another form does not rest.
 */
class RestingTest {
    private static final Path LIBRARY = Path.of("../nxt/src/main/java/arcomat/nxt/Robot.java");
    private static final Path CLOCK = Path.of("../rt/src/main/java/arcomat/rt/Cycle.java");
    private static final int OFTEN = 3;
    private static final String SCRIPT = "100 button LEFT\n900 button ESCAPE 150\n1500 end\n";

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** What is asked of a program, in place of what the tool writes. */
    private static final class Sources {
        private String robot = read(LIBRARY);
        private String clock = read(CLOCK);
        private String main = "new Dancer().run(100);";
        private String modifiers = "public static";
        private String start = "";
        private String slice = "";
        private String members = "";

        Program program() {
            String dancer =
                    """
                    import lejos.nxt.*;
                    import lejos.util.*;
                    public class Dancer extends arcomat.nxt.Robot {
                        int n;
                        static void say(Object text, int row) { LCD.drawString(text + " ", 0, row); }
                        %s
                        %s void main(String[] args) { %s }
                        protected void start() { %s }
                        protected void slice() { say(n++, 1); Motor.A.setSpeed(10 * n); %s }
                    }
                    """
                            .formatted(members, modifiers, main, start, slice);
            return Compiled.sources(
                    "Dancer",
                    Map.of(
                            "Dancer",
                            dancer,
                            "arcomat/nxt/Robot",
                            robot,
                            "arcomat/rt/Cycle",
                            clock));
        }
    }

    /** All that can be seen of runs, as text: of one brick, and of three that are not in step. */
    private static String run(LoadedProgram program, Limits limits) {
        Script script = ScriptParser.parse(SCRIPT).script().orElseThrow();
        StringBuilder text = new StringBuilder();
        for (int bricks = 1; bricks <= 3; bricks += 2) {
            try (Laboratory laboratory = new Laboratory(limits)) {
                List<Recorder> recorders = new java.util.ArrayList<>();
                List<SimulatedBrick> placed = new java.util.ArrayList<>();
                for (int i = 0; i < bricks; i++) {
                    laboratory.runUntil(3L * i);
                    SimulatedBrick brick = laboratory.place("brick" + i, program);
                    recorders.add(new Recorder());
                    brick.observe(recorders.get(i));
                    brick.play(script);
                    placed.add(brick);
                }
                laboratory.runToEnd(2000);
                for (int i = 0; i < bricks; i++) {
                    SimulatedBrick brick = placed.get(i);
                    text.append(TraceText.of(recorders.get(i).trace()))
                            .append(laboratory.time())
                            .append(brick.outcome().kind())
                            .append(brick.outcome().failure())
                            .append(recorders.get(i).lateness())
                            .append(brick.screen());
                }
            }
        }
        return text.toString();
    }

    private static void check(Program program, boolean rests) {
        for (Limits limits : List.of(Limits.OF_THE_BRICK, Limits.NONE)) {
            LoadedProgram resting = LoadedProgram.forMany(program);
            LoadedProgram onThreads = resting.onThreads();
            assertThat(resting.rests(limits.counted())).isEqualTo(rests);
            assertThat(onThreads.rests(limits.counted())).isFalse();
            String expected = run(onThreads, limits);
            for (int i = 0; i < OFTEN; i++) {
                assertThat(run(resting, limits)).as("run %d", i).isEqualTo(expected);
            }
        }
    }

    /** What may happen in a slice, or between two of them. */
    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "Thread.sleep(7);",
                "Thread.sleep(70);",
                "if (n == 3) Thread.sleep(350);",
                "Delay.msDelay(95);",
                "Motor.B.rotate(20);",
                "synchronized (this) { wait(30); }",
                "Thread t = new Helper(null); t.start(); t.join();",
                "if (n == 2) new Helper(Thread.currentThread()).start();",
                "if (n == 2) Thread.currentThread().interrupt();",
                "if (n == 4) System.exit(1);",
                "if (n == 4) throw new IllegalStateException(\"four\");",
                "Dancer.<RuntimeException>thrown(n);",
                "while (n >= 3) n++;",
                "if (n == 3) recurse(1);",
                "if (n == 3) for (int i = 0; i < 200000; i++) n = 3;",
                "many = new int[n][400];",
                "say(new UltrasonicSensor(SensorPort.S1).getDistance(), 3);",
                "if (n == 2) Button.LEFT.addButtonListener(new Listener());",
                "say(new arcomat.rt.Cycle(20).await() + \"\" + System.currentTimeMillis(), 4);",
                "Thread.sleep(3); if (Button.LEFT.isDown()) Motor.C.forward();",
            })
    void aSliceMayDoWhatItLikes(String slice) {
        Sources sources = new Sources();
        sources.slice =
                "try { " + slice + " more(); } catch (InterruptedException e) { say(e, 5); }";
        sources.members =
                """
                int[][] many;
                static void more() throws InterruptedException { }
                void recurse(int depth) { recurse(depth + 1); }
                @SuppressWarnings("unchecked")
                static <E extends Throwable> void thrown(int n) throws E {
                    if (n == 4) throw (E) new Exception("four");
                }
                static class Listener implements ButtonListener {
                    public void buttonPressed(Button b) { say("left", 6); }
                    public void buttonReleased(Button b) { say("none", 6); }
                }
                static class Helper extends Thread {
                    final Thread other;
                    Helper(Thread other) { this.other = other; }
                    public void run() {
                        Delay.msDelay(33);
                        if (other != null) other.interrupt();
                    }
                }
                """;
        check(sources.program(), true);
    }

    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "Delay.msDelay(30);",
                "throw new RuntimeException(\"no start\");",
                "Motor.A.forward(); Motor.B.forward();",
                "System.exit(0);",
                "new Thread() { public void run() { while (true) Delay.msDelay(9); } }.start();",
            })
    void soMayTheStart(String start) {
        Sources sources = new Sources();
        sources.start = start;
        check(sources.program(), true);
    }

    /** Main would be through before its last words, if its thread rested. */
    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "new Dancer().run(100); say(\"over\", 6);",
                "try { new Dancer().run(100); } finally { say(\"over\", 6); }",
                "arcomat.nxt.Robot r = new Dancer(); r.run(100);",
                "new Dancer().run(100 + (int) System.currentTimeMillis());",
                "new Other().run(100);",
            })
    void mainThatDoesMoreIsNoSuchProgram(String main) {
        Sources sources = new Sources();
        sources.main = main;
        sources.members =
                "static class Other { void run(int n) { new Dancer().again(n); } } void again(int"
                        + " n) { for (int i = 0; i < 5; i++) { slice(); Delay.msDelay(n); } }";
        check(sources.program(), false);
    }

    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(
            strings = {
                "if (n == 3) new Dancer().run(40);",
                "if (n == 3) Dancer.main(null);",
                "if (n == 3) new Thread() { public void run() { new Dancer().run(40); } }.start();",
                "if (n == 3) { Runnable r = () -> say(\"run\", 6); r.run(); }",
            })
    void aRobotThatIsRunInASliceCannotRest(String slice) {
        Sources sources = new Sources();
        sources.slice = slice;
        check(sources.program(), false);
    }

    @Tag("some-slow")
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "private void runSlices | private synchronized void runSlices",
                "private void runSlices | void runSlices",
                "public final void run(int | public final synchronized void run(int",
                "public final void run(int | public void run(int",
                "            runSlices(new Cycle(cycle)); |"
                        + " synchronized (this) { runSlices(new Cycle(cycle)); }",
                "            runSlices(new Cycle(cycle)); |"
                        + " runSlices(new Cycle(cycle)); runSlices(new Cycle(cycle));",
                "cycle.await() && | cycle.await() && cycle.await() &&",
            })
    void aRobotThatIsAnotherOneCannotRest(String usual, String other) {
        Sources sources = new Sources();
        String changed = sources.robot.replace(usual, other);
        assertThat(changed).isNotEqualTo(sources.robot);
        sources.robot = changed;
        check(sources.program(), false);
    }

    @Tag("some-slow")
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "public final class Cycle | public class Cycle",
                "public boolean await | public synchronized boolean await",
                "Thread.sleep(wait); | Thread.sleep(wait - wait / 2); Thread.sleep(wait / 2);",
                "Thread.sleep(wait); | lejos.util.Delay.msDelay(wait); if (wait < 0) throw new"
                        + " InterruptedException();",
            })
    void aClockThatIsAnotherOneLetsNobodyRest(String usual, String other) {
        Sources sources = new Sources();
        String changed = sources.clock.replace(usual, other);
        assertThat(changed).isNotEqualTo(sources.clock);
        sources.clock = changed;
        check(sources.program(), false);
    }

    /** A lock of the class that main would give back, if it came to that. */
    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(strings = "public static synchronized")
    void mainThatHoldsALockIsNoSuchProgram(String modifiers) {
        Sources sources = new Sources();
        sources.modifiers = modifiers;
        check(sources.program(), false);
    }

    /** An enumeration cannot begin again: each brick has classes of its own, and threads. */
    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(strings = "enum Step { LEFT, RIGHT }")
    void aProgramThatCannotBeginAgainDoesNotRest(String members) {
        Sources sources = new Sources();
        sources.members = members;
        check(sources.program(), false);
    }

    /** A variable that cannot be saved: two types, of which one has to be chosen. */
    @Tag("some-slow")
    @ParameterizedTest
    @ValueSource(strings = {"double x = 0.5 * cycle;", "Object[] x = {\"a\"}; Object y = x[0];"})
    void aLoopWithOtherVariablesCannotRest(String declaration) {
        Sources sources = new Sources();
        String use =
                declaration.startsWith("double") ? "LCD.drawInt((int) x, 0, 7);" : "y.hashCode();";
        sources.robot =
                sources.robot
                        .replace("            runSlices(", declaration + "            runSlices(")
                        .replace("(new Cycle(cycle));", "(new Cycle(cycle));" + use);
        check(sources.program(), false);
    }
}
