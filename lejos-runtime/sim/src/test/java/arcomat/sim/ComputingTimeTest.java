package arcomat.sim;

import static arcomat.sim.LimitedPrograms.RESULT;
import static arcomat.sim.LimitedPrograms.number;
import static arcomat.sim.LimitedPrograms.run;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.Program;
import arcomat.sim.trace.Lateness;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.api.Test;

/** Computing takes the time that it takes on the brick. */
class ComputingTimeTest {
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
}
