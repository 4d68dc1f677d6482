package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;
import arcomat.sim.load.Program;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.List;

/** Where a program meets the limits of the brick, and that it meets none without them. */
class LimitsTest {
    private static final String RESULT = "LCD.drawInt(%s, 0, 0);";

    private static SimulatedBrick run(Limits limits, Program program) {
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick brick = laboratory.place("brick", program);
            laboratory.runToEnd(600_000);
            return brick;
        }
    }

    private static SimulatedBrick run(String... body) {
        return run(Limits.OF_THE_BRICK, Compiled.main(body));
    }

    /** What a program draws in the first row, the same in two runs. */
    private static int number(Limits limits, String... body) {
        int number = Integer.parseInt(run(limits, Compiled.main(body)).screen().get(0));
        assertThat(run(limits, Compiled.main(body)).screen().get(0)).isEqualTo("" + number);
        return number;
    }

    private static int number(String... body) {
        return number(Limits.OF_THE_BRICK, body);
    }

    private static String[] untilFull(String setUp, String round) {
        return new String[] {
            "java.util.ArrayList<Object> kept = new java.util.ArrayList<Object>();",
            setUp,
            "int count = 0;",
            "try { while (count < 100000) {",
            round,
            "count++; } } catch (OutOfMemoryError e) { }",
            RESULT.formatted("count")
        };
    }

    @Test
    void whatIsKeptHasToFit() {
        // 404 bytes each, and 4 in the list.
        assertThat(number(untilFull("", "kept.add(new int[100]);"))).isBetween(105, 115);
        assertThat(number(untilFull("", "kept.add(new byte[1000]);"))).isBetween(42, 46);
        assertThat(number(untilFull("", "kept.add(new long[10][5]);"))).isBetween(90, 100);
        assertThat(number(untilFull("", "kept.add(\"number \" + count);"))).isBetween(1150, 1350);
        assertThat(number(untilFull("", "kept.add(Integer.valueOf(count));")))
                .isBetween(3500, 3900);
    }

    @Test
    void ownObjectsAreAsLargeAsTheirFields() {
        String[] body = {
            "class Small { byte a; Small next; }",
            "class Large extends Small { long b; double c; int d; }",
            "Small last = null;",
            "int count = 0;",
            "try { while (count < 100000) {",
            "Small made = new %s(); made.next = last; last = made; count++;",
            "} } catch (OutOfMemoryError e) { }",
            RESULT.formatted("count")
        };
        String text = String.join("\n", body);
        // 4 + 1 + 4 bytes are 12; 29 are 32.
        assertThat(number(text.formatted("Small"))).isBetween(3700, 3900);
        assertThat(number(text.formatted("Large"))).isBetween(1400, 1450);
    }

    @Test
    void aTextThatGrowsHasToFit() {
        assertThat(
                        number(
                                untilFull(
                                        "StringBuilder text = new StringBuilder();",
                                        "text.append(\"0123456789\");")))
                .isBetween(1100, 4000);
    }

    @Test
    void withoutLimitsThereIsRoom() {
        assertThat(number(Limits.NONE, untilFull("", "kept.add(new int[10]);"))).isEqualTo(100000);
    }

    @Test
    void garbageDoesNotCount() {
        SimulatedBrick brick =
                run(
                        "int sum = 0;",
                        "for (int i = 0; i < 5000; i++) {",
                        "  int[] numbers = new int[1000];",
                        "  sum += numbers.length + (\"x\" + i).length();",
                        "}",
                        "LCD.drawInt(sum / 1000000, 0, 0);");
        assertThat(brick.outcome().failure()).isEmpty();
        assertThat(brick.screen().get(0)).isEqualTo("5");
    }

    /** While the second is made the variable still holds the first. */
    @Test
    void aVariableHoldsItsObjectUntilItHasAnother() {
        String[] twice = {"byte[] a = new byte[30000];", "a = new byte[30000];"};
        assertThat(run(twice).outcome().failure().orElseThrow())
                .contains("java.lang.OutOfMemoryError")
                .contains("Main.java:7");
        assertThat(run(twice[0], "a = null;", twice[1]).outcome().kind())
                .isEqualTo(Outcome.Kind.ENDED);
        assertThat(run("{", twice[0], "}", "long b = 1;", twice[0]).outcome().kind())
                .as("a number has taken the place of the first")
                .isEqualTo(Outcome.Kind.ENDED);
    }

    /** A variable that nobody reads any more is one of those that the PC's compiler forgets. */
    @Test
    void aVariableOfACallerHoldsItsObject() {
        Program program =
                Compiled.source(
                        "Caller",
                        """
                        public class Caller {
                            static int sum;
                            static void inner(int round) {
                                sum += new byte[25000].length;
                                if (round % 2 == 0) { throw new IllegalStateException(); }
                            }
                            static void outer(int round) {
                                byte[] held = new byte[20000];
                                inner(round);
                            }
                            static void full() {
                                byte[] held = new byte[25000];
                                inner(1);
                            }
                            public static void main(String[] args) {
                                for (int i = 0; i < 20000; i++) {
                                    try { outer(i); } catch (IllegalStateException e) { }
                                }
                                full();
                            }
                        }
                        """);
        SimulatedBrick brick = run(Limits.OF_THE_BRICK, program);
        assertThat(brick.outcome().failure().orElseThrow())
                .contains("OutOfMemoryError")
                .contains("at Caller.inner (Caller.java:4)");
    }

    @Test
    void fieldsOfClassesAndObjectsInTheMakingHoldTheirs() {
        Program program =
                Compiled.source(
                        "Holder",
                        """
                        public class Holder {
                            static byte[] ofTheClass = new byte[15000];
                            final byte[] first = new byte[15000];
                            final byte[] second = new byte[10000];
                            final byte[] third;
                            Holder() {
                                third = new byte[10000];
                            }
                            public static void main(String[] args) {
                                new Holder();
                            }
                        }
                        """);
        assertThat(run(Limits.OF_THE_BRICK, program).outcome().failure().orElseThrow())
                .contains("OutOfMemoryError")
                .contains("Holder.java:7");
    }

    @Test
    void threadsShareTheHeap() {
        SimulatedBrick brick =
                run(
                        "final byte[][] kept = new byte[1][];",
                        "Thread other = new Thread() { public void run() {",
                        "  byte[] own = new byte[25000]; Delay.msDelay(100); own[0] = 1; } };",
                        "other.start();",
                        "Delay.msDelay(50);",
                        "try { kept[0] = new byte[25000]; LCD.drawInt(0, 0, 0); }",
                        "catch (OutOfMemoryError e) { LCD.drawInt(1, 0, 0); }",
                        "other.join();",
                        "kept[0] = new byte[25000];");
        assertThat(brick.outcome().failure()).isEmpty();
        assertThat(brick.screen().get(0)).isEqualTo("1");
    }

    private static final String DEPTH =
            """
            import lejos.nxt.LCD;
            public class Depth {
                static int depth;
                static int deepest;
                static void fall() { depth++; fall(); }
                static int measure() {
                    depth = 0;
                    try { fall(); } catch (StackOverflowError e) { return depth; }
                    return 0;
                }
                static synchronized int locked(int rest) { return rest == 0 ? measure() : locked(rest - 1) ; }
                public static void main(String[] args) throws Exception {
                    LCD.drawInt(measure(), 0, 0);
                    LCD.drawInt(measure(), 0, 1);
                    LCD.drawInt(locked(9), 0, 2);
                    Thread other = new Thread() { public void run() { LCD.drawInt(measure(), 0, 3); } };
                    other.start();
                    other.join();
                    LCD.drawInt(measure(), 0, 4);
                    fall();
                }
            }
            """;

    @Test
    void callsInEachOtherHaveToFit() {
        SimulatedBrick brick = run(Limits.OF_THE_BRICK, Compiled.source("Depth", DEPTH));
        assertThat(brick.outcome().failure().orElseThrow())
                .contains("java.lang.StackOverflowError")
                .contains("Depth.fall");
        assertThat(brick.screen()).startsWith("Exception: 15");
    }

    @Test
    void framesAreCountedPerThreadAndGivenBack() {
        String calm = DEPTH.replace("        fall();\n    }", "    }");
        SimulatedBrick brick = run(Limits.OF_THE_BRICK, Compiled.source("Depth", calm));
        // 254 with main and measure; ten more of locked; run and measure in the other thread.
        assertThat(brick.screen()).startsWith("252", "252", "242", "252", "252");
    }

    @Test
    void computingTakesTime() {
        String[] body = {
            "long begin = System.currentTimeMillis();",
            "int x = 0;",
            "for (int i = 0; i < 10000; i++) { x += i; }",
            RESULT.formatted("(int) (System.currentTimeMillis() - begin)")
        };
        // Nine instructions a round.
        assertThat(number(body)).isEqualTo(180);
        assertThat(number(Limits.NONE, body)).isEqualTo(100);
    }

    @Test
    void callsTakeTimeAlsoWithoutLoops() {
        Program program =
                Compiled.source(
                        "Fibonacci",
                        """
                        public class Fibonacci {
                            static int of(int n) { return n < 2 ? n : of(n - 1) + of(n - 2); }
                            public static void main(String[] args) {
                                long begin = System.currentTimeMillis();
                                of(15);
                                long taken = System.currentTimeMillis() - begin;
                                lejos.nxt.LCD.drawInt((int) taken, 0, 0);
                            }
                        }
                        """);
        // 1973 calls.
        assertThat(run(Limits.OF_THE_BRICK, program).screen().get(0)).isEqualTo("49");
    }

    /** There is one processor. */
    @Test
    void whoComputesKeepsOthersFromIt() {
        String[] body = {
            "Thread busy = new Thread() { public void run() { while (true) { } } };",
            "busy.setDaemon(true);",
            "%s",
            "long begin = System.currentTimeMillis();",
            "for (int i = 0; i < 10000; i++) { }",
            RESULT.formatted("(int) (System.currentTimeMillis() - begin)")
        };
        String text = String.join("\n", body);
        int alone = number(text.formatted(""));
        int together = number(text.formatted("busy.start();"));
        assertThat(together).isBetween(2 * alone - 10, 2 * alone + 10);
    }

    /** The PC locks its Vector while it asks the program's objects whether they are the same. */
    @Test
    void aLockOfThePcKeepsNobody() {
        Program program =
                Compiled.source(
                        "Vectors",
                        """
                        public class Vectors {
                            static final java.util.Vector<Object> VECTOR =
                                    new java.util.Vector<Object>();
                            final int number;
                            Vectors(int number) { this.number = number; }
                            public boolean equals(Object other) {
                                int sum = 0;
                                for (int i = 0; i < 100; i++) { sum += i; }
                                return sum > 0 && ((Vectors) other).number == number;
                            }
                            static class Searcher extends Thread {
                                public void run() {
                                    for (int i = 0; i < 50; i++) { VECTOR.contains(new Vectors(20)); }
                                }
                            }
                            public static void main(String[] args) throws Exception {
                                for (int i = 0; i < 10; i++) { VECTOR.addElement(new Vectors(i)); }
                                long begin = System.currentTimeMillis();
                                Thread one = new Searcher();
                                Thread two = new Searcher();
                                one.start();
                                two.start();
                                one.join();
                                two.join();
                                int taken = (int) (System.currentTimeMillis() - begin);
                                lejos.nxt.LCD.drawInt(taken / 1000, 0, 0);
                            }
                        }
                        """);
        try (Laboratory laboratory = new Laboratory()) {
            laboratory.limit(java.time.Duration.ofSeconds(60));
            SimulatedBrick brick = laboratory.place("brick", program);
            laboratory.runToEnd(600_000);
            assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.ENDED);
            assertThat(brick.screen().get(0)).isEqualTo("1");
        }
    }

    /** What comes before the first look at the clock belongs to switching on. */
    @Test
    void theFirstSliceBeginsAtZero() {
        assertThat(
                        number(
                                "int[] x = new int[100];",
                                "for (int i = 0; i < 100; i++) { x[i] = i; }",
                                RESULT.formatted("(int) System.currentTimeMillis()")))
                .isZero();
        assertThat(
                        number(
                                "for (int i = 0; i < 100000; i++) { }",
                                RESULT.formatted("(int) System.currentTimeMillis()")))
                .isGreaterThan(500);
    }

    private static Lateness lateness(int work) {
        try (Laboratory laboratory = new Laboratory()) {
            Program program =
                    Compiled.main(
                            "long next = System.currentTimeMillis();",
                            "for (int slice = 0; slice < 10; slice++) {",
                            "  for (int i = 0; i < " + work + "; i++) { }",
                            "  next += 100;",
                            "  Delay.msDelay(next - System.currentTimeMillis());",
                            "}");
            SimulatedBrick brick = laboratory.place("brick", program);
            Recorder recorder = new Recorder();
            brick.observe(recorder);
            laboratory.runToEnd(60_000);
            assertThat(recorder.trace().cycles()).hasSize(11);
            return recorder.lateness();
        }
    }

    @Test
    void aSliceThatTakesTooLongIsLate() {
        assertThat(lateness(9_000)).isEqualTo(Lateness.NONE);
        Lateness late = lateness(15_000);
        assertThat(late.slices()).isEqualTo(10);
        assertThat(late.longest()).isBetween(145_000L, 155_000L);
    }

    @Test
    void anErrorThatNothingCatchesIsShownAsOnTheBrick() {
        SimulatedBrick brick =
                run(
                        "LCD.drawString(\"before\", 0, 3);",
                        "Motor.A.forward();",
                        "new Thread() { public void run() {",
                        "  Delay.msDelay(100);",
                        "  throw new IllegalStateException(\"oops\"); } }.start();",
                        "Delay.msDelay(1000);",
                        "Motor.A.backward();");
        assertThat(brick.outcome().failure().orElseThrow()).contains("oops");
        assertThat(brick.screen()).isEqualTo(rows("Exception: 31", "oops"));
        assertThat(brick.motor(MotorName.A).order()).isEqualTo(MotorOrder.FLOAT);
        SimulatedBrick own = run("class Own extends RuntimeException { } throw new Own();");
        assertThat(own.screen()).isEqualTo(rows("Exception: ?"));
        SimulatedBrick ideal = run(Limits.NONE, Compiled.main("throw new Error();"));
        assertThat(ideal.screen()).isEqualTo(rows());
    }

    @Test
    void anErrorThatFailsToSayWhatItIsEndsTheProgramToo() {
        SimulatedBrick brick =
                run(
                        "class Own extends RuntimeException {",
                        "  public String getMessage() { throw new Error(); } }",
                        "new Thread() { public void run() { Delay.msDelay(100000); } }.start();",
                        "throw new Own();");
        assertThat(brick.outcome().kind()).isEqualTo(Outcome.Kind.FAILED);
        assertThat(brick.outcome().failure().orElseThrow()).startsWith("Main$1Own at Main.main");
        assertThat(brick.screen()).isEqualTo(rows("Exception: ?"));
    }

    private static List<String> rows(String... first) {
        List<String> rows = new java.util.ArrayList<>(List.of(first));
        while (rows.size() < 8) {
            rows.add("");
        }
        return rows;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "27: int x = 1 / (args == null ? 0 : 1);",
                "16: args[0] = null;",
                "28: int[] x = new int[3]; x[3] = 1;",
                "35: Object x = new int[args == null ? -1 : 1];",
                "26: Object x = \"\"; ((Integer) x).intValue();",
                "34: Object[] x = new String[1]; x[0] = Integer.valueOf(1);",
                "3: int[] x = new int[30000];",
            })
    void theMachinesErrorsHaveANumberAndNoMessage(String row) {
        String number = row.substring(0, row.indexOf(':'));
        String failing = row.substring(row.indexOf(':') + 1);
        assertThat(run(failing).screen()).isEqualTo(rows("Exception: " + number));
        SimulatedBrick brick =
                run(
                        "try {",
                        failing,
                        "} catch (Throwable e) {",
                        "LCD.drawString(e.getMessage() == null ? \"none\" : \"some\", 0, 0);",
                        "LCD.drawString(e.toString(), 0, 1);",
                        "LCD.drawString(\"+\" + e, 0, 2);",
                        "}");
        assertThat(brick.screen()).startsWith("none", "class " + number, "+class " + number);
    }

    @Test
    void whatTheProgramMakesItselfKeepsItsMessage() {
        SimulatedBrick brick =
                run(
                        "class Own extends RuntimeException {",
                        "  public String toString() { return \"own\"; } }",
                        "LCD.drawString(new ArithmeticException(\"a\").getMessage(), 0, 4);",
                        "LCD.drawString(new ArithmeticException(\"a\").toString(), 0, 1);",
                        "LCD.drawString(new RuntimeException(\"b\").toString(), 0, 2);",
                        "LCD.drawString(new Own().toString() + new Own(), 0, 3);",
                        "new IllegalStateException(\"c\").printStackTrace();");
        assertThat(brick.outcome().failure()).isEmpty();
        assertThat(brick.screen())
                .startsWith("class 31: c", "class 27: a", "class ?: b", "ownown", "a");
    }
}
