package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.Program;

import org.junit.jupiter.api.Test;

import java.lang.management.ManagementFactory;
import java.util.Arrays;

/** Much robot time in little PC time, and no garbage. */
class SpeedTest {
    private static final long MINUTE = 60_000;
    private static final long TEN_MINUTES = 10 * MINUTE;

    /** Two eyes, a light sensor, a button and two motors, every 100 ms: like the coffee fetcher. */
    private static final Program FETCHER =
            Compiled.main(
                    "UltrasonicSensor front = new UltrasonicSensor(SensorPort.S1);",
                    "UltrasonicSensor side = new UltrasonicSensor(SensorPort.S2);",
                    "LightSensor left = new LightSensor(SensorPort.S3);",
                    "long next = System.currentTimeMillis();",
                    "while (!Button.ESCAPE.isDown()) {",
                    "  int near = Math.min(front.getDistance(), side.getDistance());",
                    "  int light = left.getLightValue();",
                    "  Motor.A.setSpeed(near < 20 ? 0 : 100 + light);",
                    "  Motor.A.forward();",
                    "  Motor.B.setSpeed(near < 20 ? 0 : 200 - light);",
                    "  if (near < 20) Motor.B.stop(true); else Motor.B.forward();",
                    "  LCD.drawInt(near, 3, 0, 0);",
                    "  next += 100;",
                    "  Delay.msDelay(next - System.currentTimeMillis());",
                    "}");

    @Test
    void tenMinutesTakeLessThanTwoSeconds() {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("fetcher", FETCHER);
            long start = ManagementFactory.getRuntimeMXBean().getUptime();
            laboratory.runUntil(TEN_MINUTES);
            long taken = ManagementFactory.getRuntimeMXBean().getUptime() - start;
            assertThat(brick.isRunning()).isTrue();
            assertThat(taken).as("milliseconds").isLessThan(2000);
        }
    }

    @Test
    void aSteadyProgramAllocatesNothing() {
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("fetcher", FETCHER);
            laboratory.runUntil(1); // from now on a thread of the PC carries it
            long least = Long.MAX_VALUE;
            for (int minute = 1; minute <= TEN_MINUTES / MINUTE; minute++) {
                brick.expose(SensorName.S1, Stimulus.value(minute % 2 == 0 ? 15 : 45));
                long before = allocated();
                laboratory.runUntil(minute * MINUTE);
                least = Math.min(least, allocated() - before);
            }
            // The least of ten: now and then the PC's Java itself allocates, when it compiles anew.
            assertThat(least).isZero();
        }
    }

    /** Bytes that the program's only thread has allocated so far. */
    private static long allocated() {
        var threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        return Arrays.stream(threads.getThreadInfo(threads.getAllThreadIds()))
                .filter(thread -> thread != null && thread.getThreadName().equals("fetcher main"))
                .mapToLong(thread -> threads.getThreadAllocatedBytes(thread.getThreadId()))
                .max()
                .orElseThrow();
    }
}
