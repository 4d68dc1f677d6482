package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Program;
import arcomat.source.SourceFile;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/** What several worlds share is made once, and is the same as if each had made its own. */
class ProgramCacheTest {
    private static final String RUNNER =
            """
            package p;
            import nxt.Brick.MotorPort;
            import nxt.Brick.SensorPort;
            import nxt.LcdLogger;
            import nxt.RegulatedMotor;
            import nxt.UltrasonicSensor;

            component Runner%s {
                Integer pace = %s;

                component UltrasonicSensor(SensorPort.S1) eye;
                component RegulatedMotor(MotorPort.A) left;
                component RegulatedMotor(MotorPort.B) right;
                component LcdLogger(0) display;
                component Mind(pace, %s) mind;

                connect eye.distance -> mind.distance;
                connect mind.speed -> left.speed, right.speed;
                connect mind.doing -> display.text;
            }
            """;
    private static final String MIND =
            """
            package p;
            component Mind(Integer cruise, String words) {
                timing instant;
                port <<total>> in Integer[0..255] distance, out Integer speed, out String doing;

                <<completion = "ignore">> automaton {
                    state standing, driving;
                    initial standing;
                    standing -> driving [distance > 40] / {speed = cruise, doing = words};
                    driving -> standing [distance <= 20] / {speed = 0, doing = "standing"};
                }
            }
            """;
    private static final String WORLD =
            """
            parameter program p.Runner
            floor 3000 1000
            seconds 8
            wall 2500 200  2500 800
            kind runner
              program component $program in m
              body 80 900
              wheels A B
              ultrasonic S1 at 75 0
            robot one runner at 300 500
            """;

    @TempDir private Path folder;
    private final List<String> steps = new ArrayList<>();

    @BeforeEach
    void write() throws IOException {
        Files.createDirectories(folder.resolve("m/p"));
        write(
                "Runner",
                RUNNER.formatted("(Integer cruise, String words = \"go\")", "cruise / 2", "words"));
        write("Mind", MIND);
        Files.writeString(folder.resolve("w.world"), WORLD);
    }

    private void write(String component, String text) throws IOException {
        Files.writeString(folder.resolve("m/p/" + component + ".arc"), text);
    }

    private PreparedWorld prepared(String program, ProgramCache cache) throws WrongUse {
        Session session = Session.in(folder, steps::add);
        return new PrepareWorld("w.world", false, Map.of("program", program)).run(session, cache);
    }

    private long count(String work) {
        return steps.stream().filter(step -> step.startsWith(work)).count();
    }

    @Tag("slow")
    @Test
    void modelsAreCheckedOnceAndEachProgramIsMadeOnce() throws WrongUse {
        ProgramCache cache = new ProgramCache();
        for (int speed : List.of(100, 200, 300, 200, 100)) {
            assertThat(prepared("p.Runner(%d)".formatted(speed), cache).findings()).isEmpty();
        }
        assertThat(count("checking")).isEqualTo(1);
        assertThat(count("making the program")).isEqualTo(3);
    }

    @Tag("slow")
    @Test
    void whatIsSharedIsWhatIsMadeAlone() throws WrongUse {
        ProgramCache cache = new ProgramCache();
        prepared("p.Runner(100)", cache);
        Program shared = program("p.Runner(360)", cache);
        assertThat(bytes(shared)).isEqualTo(bytes(program("p.Runner(360)", new ProgramCache())));
        assertThat(bytes(shared)).isNotEqualTo(bytes(program("p.Runner(100)", cache)));
    }

    private Program program(String component, ProgramCache cache) {
        World world =
                WorldParser.parse(new SourceFile("w.world", WORLD), Map.of("program", component))
                        .world()
                        .orElseThrow();
        Session session = Session.in(folder, steps::add);
        WorldPrograms.Result result = WorldPrograms.of(world, "w.world", false, session, cache);
        LoadedProgram loaded = Objects.requireNonNull(result.equipment().get("one")).program();
        return Objects.requireNonNull(loaded).program();
    }

    private static Map<String, List<Byte>> bytes(Program program) {
        Map<String, List<Byte>> bytes = new TreeMap<>();
        program.classes()
                .forEach(
                        (name, code) -> {
                            List<Byte> content = new ArrayList<>();
                            for (byte each : code) {
                                content.add(each);
                            }
                            bytes.put(name, content);
                        });
        return bytes;
    }

    /** Whether a value is an argument, or stands in the model: it is the same program. */
    @Tag("slow")
    @Test
    void anArgumentIsWhatAConstantIs() throws IOException {
        Program given = program("p.Runner(360, \"go (on), #1\")", new ProgramCache());
        write("Runner", RUNNER.formatted("", "360 / 2", "\"go (on), #1\""));
        assertThat(bytes(given)).isEqualTo(bytes(program("p.Runner", new ProgramCache())));
    }

    /** Findings about models are told of each world, and only where they matter. */
    @Tag("slow")
    @Test
    void aBrokenFileIsInTheWayOfWhoNeedsIt() throws IOException, WrongUse {
        write("Broken", "package p; component Broken { prot in Boolean on; }");
        write("Odd", "package p; component Odd { component Broken broken; }");
        ProgramCache cache = new ProgramCache();
        for (int again = 0; again < 2; again++) {
            PreparedWorld fine = prepared("p.Runner(%d)".formatted(100 + again), cache);
            assertThat(fine.findings()).isEmpty();
            assertThat(fine.aside().files()).containsExactly("m/p/Broken.arc", "m/p/Odd.arc");
            assertThat(prepared("p.Odd", cache).canRun()).isFalse();
        }
    }

    @Test
    void argumentsThatDoNotFitAreTold() throws WrongUse {
        ProgramCache cache = new ProgramCache();
        for (int again = 0; again < 2; again++) {
            assertThat(prepared("p.Runner(fast)", cache).findings())
                    .singleElement()
                    .satisfies(
                            finding ->
                                    assertThat(finding.message())
                                            .contains("'fast' of 'p.Runner' is not a value of"));
        }
        assertThat(count("making the program")).isZero();
    }
}
