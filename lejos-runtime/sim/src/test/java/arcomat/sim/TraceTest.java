package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.MotorName;
import arcomat.sim.device.MotorOrder;
import arcomat.sim.device.SensorName;
import arcomat.sim.load.Program;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.trace.Cycle;
import arcomat.sim.trace.Event;

import org.junit.jupiter.api.Test;

import java.util.List;
import java.util.Map;

/** A trace has the cycles of the program's main loop, whatever other threads do. */
class TraceTest {
    private static final Program PROGRAM =
            Compiled.main(
                    "Thread busy = new Thread() { public void run() {",
                    "  while (true) Delay.msDelay(7); } };",
                    "busy.setDaemon(true);",
                    "busy.start();",
                    "TouchSensor touch = new TouchSensor(SensorPort.S2);",
                    "UltrasonicSensor eye = new UltrasonicSensor(SensorPort.S1);",
                    "long next = System.currentTimeMillis();",
                    "for (int i = 0; i < 4; i++) {",
                    "  Motor.A.setSpeed(10 * eye.getDistance());",
                    "  if (touch.isPressed()) Motor.A.forward(); else Motor.A.flt(true);",
                    "  next += 100;",
                    "  Delay.msDelay(next - System.currentTimeMillis());",
                    "}");

    @Test
    void cyclesAreWhatHappensBetweenSleeps() {
        String script = "0 S1 30\n100 S2 pressed\n300 S1 40";
        List<Cycle> cycles =
                BrickRun.of(
                                "brick",
                                PROGRAM,
                                ScriptParser.parse(script).script().orElseThrow(),
                                999)
                        .trace()
                        .cycles();
        assertThat(cycles)
                .extracting(Cycle::start)
                .containsExactly(0L, 100_000L, 200_000L, 300_000L, 400_000L);
        assertThat(cycles.get(0).read()).isEqualTo(Map.of(SensorName.S1, 30, SensorName.S2, 0));
        assertThat(cycles.get(3).read()).isEqualTo(Map.of(SensorName.S1, 40, SensorName.S2, 1));
        assertThat(cycles.get(1).orders())
                .extracting(
                        Event.MotorOrdered::motor,
                        Event.MotorOrdered::order,
                        Event.MotorOrdered::value)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple(MotorName.A, MotorOrder.TURN, 300));
        assertThat(cycles.get(2).orders()).as("nothing new").isEmpty();
        assertThat(cycles.get(4).orders())
                .as("the end lets the motors go")
                .extracting(Event.MotorOrdered::order)
                .containsExactly(MotorOrder.FLOAT);
    }
}
