package arcomat.pipeline.brick;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.brick.need.Needs;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Model;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.check.CheckedAnswer;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.pipeline.generate.RobotBuilder;
import arcomat.report.brick.BrickTraceText;
import arcomat.report.text.Style;
import arcomat.sim.Laboratory;
import arcomat.sim.SimulatedBrick;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;
import arcomat.sim.load.Program;
import arcomat.simulate.run.Choice;
import arcomat.simulate.run.Interpreter;
import arcomat.simulate.run.Simulation;
import arcomat.simulate.watch.Watch;
import arcomat.simulate.watch.Watching;
import arcomat.source.SourceFile;
import arcomat.symbols.Scenario;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Robots that watch themselves, on simulated bricks. {@code -PrefreshGolden} writes the expected
 * runs anew; read them.
 */
class WatchedRobotTest {
    private static final String ROVER = "src/test/resources/watched";
    private static final Path SCRIPT = Path.of(ROVER, "rover.script");
    private static final List<String> FETCHER_KEEPS =
            List.of(
                    "coffee.fig3.AvoidCrash",
                    "coffee.fig6.AvoidCrash",
                    "coffee.parts.Timer(2)",
                    "coffee.parts.Proximity(25, 35)",
                    "coffee.fetcher.LineStatusComp(45)",
                    "coffee.fetcher.CupHolder",
                    "coffee.fetcher.Drive");

    private static final Pattern MILLISECONDS =
            Pattern.compile("(?<=^ {0,9})\\d+", Pattern.MULTILINE);
    private static final int CYCLE = 100;

    @TempDir private Path folder;

    private Path built(String main, List<String> monitors, String models) throws WrongUse {
        return folder.resolve("brick").resolve(robot(main, monitors, models).jar());
    }

    private RobotBuilder.BrickProgram robot(String main, List<String> monitors, String models)
            throws WrongUse {
        String out = folder.resolve("brick").toString();
        GenerateCode task =
                new GenerateCode("lejos", out, Optional.of(main), false, monitors, List.of(models));
        CheckedAnswer<GenerateCode.Made> answer = Session.in(Path.of(""), Progress.NONE).run(task);
        assertThat(answer.check().findings()).isEmpty();
        GenerateCode.Made result = answer.value().orElseThrow();
        assertThat(result.watches()).hasSizeGreaterThanOrEqualTo(monitors.size());
        return result.robots().get(0);
    }

    private static RunJar.Run run(Path jar, String script) throws WrongUse {
        RunJar task = new RunJar(jar.toString(), Optional.of(script), OptionalInt.empty());
        return Session.in(Path.of(""), Progress.NONE).run(task).run().orElseThrow();
    }

    @ParameterizedTest
    @CsvSource({
        "holds, p.Stands",
        "stops, front.reflex=p.Retreats(90)#stops",
        "goes-on, front.reflex=p.Retreats(90)#tells",
        "gives-up, front.reflex=p.Guesses",
        "both, front.reflex=p.Guesses front.reflex=p.Retreats(90)#tells p.Stands"
    })
    void showsWhatIsViolated(String expected, String monitors) throws Exception {
        Path jar = built("p.Rover", List.of(monitors.split(" ")), ROVER);
        RunJar.Run run = run(jar, ROVER + "/rover.script");
        assertThat(run.failure()).isEmpty();
        String actual =
                BrickTraceText.render(run.trace(), Style.PLAIN)
                        + String.join("\n", run.screen())
                        + "\n"
                        + run.ending()
                        + "\n";
        Path file = Path.of(ROVER, expected + ".txt");
        if (Boolean.getBoolean("golden.refresh")) {
            Files.writeString(file, actual);
        }
        assertThat(actual).isEqualTo(Files.readString(file));
    }

    /** In the same slice and the same words; rows of the display break lines anywhere. */
    @Test
    void theBrickSaysWhatTheSimulatorSays() throws Exception {
        Model model = Lowering.lower(Scenario.models(ROVER));
        Component reflex = model.component("p.Reflex").orElseThrow();
        Component retreats = model.component("p.Retreats").orElseThrow();
        List<Letter> letters =
                IntStream.range(0, 10)
                        .mapToObj(slice -> List.<Value>of(new Value.BooleanValue(slice >= 5)))
                        .map(pressed -> new Letter(Map.of("pressed", pressed)))
                        .toList();
        Trace trace =
                Simulation.run(
                        new Interpreter(
                                reflex, List.of(new Value.IntegerValue(360)), Choice.first()),
                        letters);
        Watch watch =
                new Watch(
                        retreats,
                        retreats.automata().get(0),
                        List.of(new Value.IntegerValue(90)),
                        reflex);
        String said =
                Watching.all(List.of(watch), trace).get(0).violation().orElseThrow().message();

        Path jar = built("p.Rover", List.of("front.reflex=p.Retreats(90)#stops"), ROVER);
        String shown = String.join("", run(jar, ROVER + "/rover.script").screen());
        assertThat(shown.replace(" ", "")).isEqualTo(said.replace(" ", "")).startsWith("slice7:");
    }

    /** Who watches works longer in a slice: the same happens, if not in the same millisecond. */
    private static String inSlices(String trace) {
        return MILLISECONDS
                .matcher(trace)
                .replaceAll(time -> String.valueOf(Integer.parseInt(time.group()) / CYCLE));
    }

    /** Each part keeps what it is, delayed or not, and what it refines. */
    @Test
    void theFetcherKeepsWhatItsPartsAre() throws Exception {
        Path jar = built("coffee.fetcher.Fetcher", FETCHER_KEEPS, "models/coffee");
        RunJar.Run run = run(jar, "models/coffee/scripts/fetcher.script");
        assertThat(run.screen()).isEmpty();
        String trace = BrickTraceText.render(run.trace(), Style.PLAIN);
        assertThat(inSlices(Files.readString(Path.of("src/test/resources/robots/fetcher.txt"))))
                .startsWith(inSlices(trace));
    }

    /**
     * Of what is predicted for robots that watch themselves, nothing is below what happens on a
     * simulated brick. It is at most so much, and no reason to refuse a robot.
     */
    @ParameterizedTest
    @CsvSource({
        "p.Stands, 5.6, 20",
        "front.reflex=p.Retreats(90)#stops, 5.6, 20",
        "front.reflex=p.Retreats(90)#tells, 7.2, 70",
        "front.reflex=p.Guesses, 15, 12000",
        "front.reflex=p.Guesses front.reflex=p.Retreats(90)#tells p.Stands, 20, 12000"
    })
    void needsNoMoreThanIsPredicted(String monitors, double kilobytes, double milliseconds)
            throws Exception {
        RobotBuilder.BrickProgram robot = robot("p.Rover", List.of(monitors.split(" ")), ROVER);
        Needs needs = robot.report().needs();
        Needs without = robot("p.Rover", List.of(), ROVER).report().needs();
        SliceObserver slices = new SliceObserver();
        try (Laboratory laboratory = new Laboratory()) {
            Path jar = built("p.Rover", List.of(monitors.split(" ")), ROVER);
            SimulatedBrick brick = laboratory.place("rover", Program.read(jar));
            brick.observe(slices);
            SourceFile script = new SourceFile("rover", Files.readString(SCRIPT));
            brick.play(ScriptText.read(script).script().orElseThrow());
            laboratory.runToEnd(3000);
        }

        assertThat(needs.memory().isBound()).isTrue();
        assertThat(needs.memory().amount().orElseThrow())
                .isGreaterThan(without.memory().amount().orElseThrow())
                .isLessThan((long) (kilobytes * 1000));
        assertThat(needs.slice().isBound()).isTrue();
        assertThat(needs.slice().amount().orElseThrow())
                .isGreaterThan(slices.longest())
                .isLessThan((long) (milliseconds * 1000));
        assertThat(robot.report().fits()).isTrue();
    }

    /** Who goes on says what text there was, which takes as long as the text is. */
    @ParameterizedTest
    @CsvSource({
        "crier=p.Names#stops,",
        "crier=p.Names#tells, 'arcomat.rt.Accusation.quoted takes the longer, the longer a text is"
                + " that is watched'"
    })
    void textsThatAreToldHaveAnyLength(String monitor, String why) throws Exception {
        Needs needs = robot("p.Herald", List.of(monitor), ROVER).report().needs();

        assertThat(needs.slice().unknown()).isEqualTo(Optional.ofNullable(why));
        assertThat(needs.memory().unknown()).isEmpty();
    }

    @Test
    void toWatchAllocatesNothing() throws Exception {
        Program fetcher =
                Program.read(built("coffee.fetcher.Fetcher", FETCHER_KEEPS, "models/coffee"));
        AllocationObserver allocations = new AllocationObserver();
        try (Laboratory laboratory = new Laboratory()) {
            SimulatedBrick brick = laboratory.place("fetcher", fetcher);
            brick.expose(SensorName.S1, Stimulus.value(100));
            brick.expose(SensorName.S2, Stimulus.value(20));
            brick.expose(SensorName.S3, Stimulus.value(20));
            brick.expose(SensorName.S4, Stimulus.value(0));
            brick.observe(allocations);
            laboratory.runToEnd(60_000);
        }
        assertThat(allocations.cycles()).isGreaterThan(500);
        assertThat(allocations.bytes()).isZero();
    }

    /** Nor whatever belongs to it: who does not watch has the jar that there always was. */
    @Test
    void aRobotThatDoesNotWatchItselfHasNoMonitor() throws Exception {
        String entries = new String(CoffeeRobot.of("coffee.fetcher.Fetcher").jar(), "ISO-8859-1");
        assertThat(entries).contains("arcomat/nxt/Robot").doesNotContain("Watched", "Monitor");
    }
}
