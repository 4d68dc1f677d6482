package arcomat.sim;

import static arcomat.sim.LimitedPrograms.run;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;

import org.junit.jupiter.api.Test;

/** As many calls in each other as the brick has frames for. */
class CallLimitTest {
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
}
