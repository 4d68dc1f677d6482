package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.load.LineProbe;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** What a run has come to is noted, and nothing else is changed by that. */
class LineProbeTest {
    private static final String SOURCE =
            """
            import lejos.nxt.*;
            public class Ways {
                static int rounds;
                Object made;
                static boolean pressed(TouchSensor sensor) {
                    rounds++;
                    if (sensor.isPressed()) {
                        return true;
                    }
                    return false;
                }
                Ways(int size) {
                    if (size > 2) {
                        made = new int[size];
                        return;
                    }
                }
                public static void main(String[] args) throws Exception {
                    TouchSensor sensor = new TouchSensor(SensorPort.S1);
                    for (int i = 0; i < 20; i++) {
                        new Ways(pressed(sensor) ? 5 : 1);
                        switch (rounds % 3) {
                            case 0:
                                Motor.A.forward();
                                break;
                            case 1:
                                Motor.A.stop();
                                break;
                            default:
                                throw new IllegalStateException("never"
                                    + rounds);
                        }
                        rounds += rounds % 3 == 1 ? 1 : 0;
                        Thread.sleep(100);
                    }
                    LCD.drawString(rounds + " rounds", 0, 0);
                }
            }
            """;

    private static final Program WAYS = Compiled.source("Ways", SOURCE);

    private static int line(String text) {
        List<String> lines = SOURCE.lines().map(String::strip).toList();
        assertThat(lines).containsOnlyOnce(text);
        return lines.indexOf(text) + 1;
    }

    private static List<LineProbe> probes() {
        List<LineProbe> probes = new ArrayList<>();
        for (String text :
                List.of(
                        "return true;",
                        "return false;",
                        "return;",
                        "made = new int[size];",
                        "throw new IllegalStateException(\"never\"",
                        "Motor.A.stop();",
                        "LCD.drawString(rounds + \" rounds\", 0, 0);")) {
            probes.add(new LineProbe("Ways", line(text), probes.size()));
        }
        probes.add(new LineProbe("Other", 1, probes.size()));
        return probes;
    }

    private static String run(LoadedProgram program, String script, Limits limits, BitSet reached) {
        Script steps = ScriptParser.parse(script).script().orElseThrow();
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick brick = laboratory.place("brick", program);
            brick.observe(recorder);
            brick.play(steps);
            laboratory.runToEnd(60_000);
            reached.or(brick.reached());
            return TraceText.of(recorder.trace()) + laboratory.time() + brick.outcome().failure();
        }
    }

    /** Bricks take over classes of earlier ones: what these have noted is not theirs. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void eachRunNotesWhatItHasComeTo(boolean counted) {
        Limits limits = counted ? Limits.OF_THE_BRICK : Limits.NONE;
        LoadedProgram plain = LoadedProgram.forMany(WAYS);
        LoadedProgram probed = LoadedProgram.forMany(WAYS, List.of(), probes());
        assertThat(probed.repeats(counted)).isTrue();
        for (int i = 0; i < 3; i++) {
            check(plain, probed, "0 S1 pressed\n1500 end\n", limits, "{0, 2, 3, 5}");
            check(plain, probed, "0 S1 released\n", limits, "{1, 5, 6}");
            check(plain, probed, "0 S1 released\n700 S1 pressed\n", limits, "{0, 1, 2, 3, 5, 6}");
        }
    }

    private static void check(
            LoadedProgram plain,
            LoadedProgram probed,
            String script,
            Limits limits,
            String expected) {
        BitSet reached = new BitSet();
        BitSet none = new BitSet();
        assertThat(run(probed, script, limits, reached))
                .isEqualTo(run(plain, script, limits, none));
        assertThat(reached).hasToString(expected);
        assertThat(none.isEmpty()).isTrue();
    }
}
