package arcomat.sim;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.sim.device.Limits;
import arcomat.sim.device.LineNotes;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.NotedLines;
import arcomat.sim.load.Program;
import arcomat.sim.script.Script;
import arcomat.sim.script.ScriptParser;
import arcomat.sim.trace.Recorder;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.List;

/** What each object has come to is noted, and nothing else is changed by that. */
class LineNotesTest {
    private static final String SOURCE =
            """
            import lejos.nxt.*;
            public class Ways {
                static int rounds;
                Object made;
                boolean pressed(TouchSensor sensor) {
                    rounds++;
                    if (sensor.isPressed()) {
                        return true;
                    }
                    return false;
                }
                Ways(int size) {
                    new String("way");
                    if (size > 2) {
                        made = new int[size];
                        return;
                    }
                    size = 0;
                }
                static class Wide extends Ways {
                    Wide() {
                        super(9);
                    }
                }
                public static void main(String[] args) throws Exception {
                    TouchSensor sensor = new TouchSensor(SensorPort.S1);
                    Ways other = new Wide();
                    Ways ways = new Ways(1);
                    for (int i = 0; i < 20; i++) {
                        if (ways.pressed(sensor) && i == 9) {
                            other.pressed(sensor);
                        }
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

    private static NotedLines noted() {
        List<Integer> lines = new ArrayList<>();
        for (String text :
                List.of(
                        "return true;",
                        "return false;",
                        "return;",
                        "made = new int[size];",
                        "size = 0;",
                        "new String(\"way\");",
                        "Motor.A.stop();")) {
            lines.add(line(text));
        }
        lines.add(0);
        return new NotedLines("Ways", lines);
    }

    /** With the objects in the order in which they were made. */
    private static String run(
            LoadedProgram program, String script, Limits limits, List<String> notes) {
        Script steps = ScriptParser.parse(script).script().orElseThrow();
        Recorder recorder = new Recorder();
        try (Laboratory laboratory = new Laboratory(limits)) {
            SimulatedBrick brick = laboratory.place("brick", program);
            brick.observe(recorder);
            brick.play(steps);
            laboratory.runToEnd(60_000);
            brick.notes().forEach(each -> notes.add(text(each)));
            return TraceText.of(recorder.trace()) + laboratory.time() + brick.outcome().failure();
        }
    }

    private static String text(LineNotes notes) {
        return notes.object().getClass().getSimpleName() + " " + notes.numbers();
    }

    /** Bricks take over classes of earlier ones: what these have noted is not theirs. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void eachObjectNotesWhatItHasComeTo(boolean counted) {
        Limits limits = counted ? Limits.OF_THE_BRICK : Limits.NONE;
        LoadedProgram plain = LoadedProgram.forMany(WAYS);
        NotedLines elsewhere = new NotedLines("Other", List.of(1));
        LoadedProgram noting = LoadedProgram.forMany(WAYS, List.of(), List.of(elsewhere, noted()));
        assertThat(noting.repeats(counted)).isTrue();
        for (int i = 0; i < 3; i++) {
            check(plain, noting, "0 S1 pressed\n", limits, "{0, 2, 3, 5}", "{0, 4, 5}");
            check(plain, noting, "0 S1 released\n", limits, "{2, 3, 5}", "{1, 4, 5}");
            String later = "0 S1 released\n1500 S1 pressed\n";
            check(plain, noting, later, limits, "{2, 3, 5}", "{0, 1, 4, 5}");
        }
    }

    private static void check(
            LoadedProgram plain,
            LoadedProgram noting,
            String script,
            Limits limits,
            String wide,
            String narrow) {
        List<String> notes = new ArrayList<>();
        List<String> none = new ArrayList<>();
        assertThat(run(noting, script, limits, notes)).isEqualTo(run(plain, script, limits, none));
        assertThat(notes).containsExactly("Wide " + wide, "Ways " + narrow);
        assertThat(none).isEmpty();
    }
}
