package arcomat.sim;

import static arcomat.sim.LimitedPrograms.RESULT;
import static arcomat.sim.LimitedPrograms.number;
import static arcomat.sim.LimitedPrograms.run;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.Program;

import org.junit.jupiter.api.Test;

/** A program may hold as many objects as the heap of the brick has room for. */
class MemoryLimitTest {
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
}
