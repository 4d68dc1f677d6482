package arcomat.pipeline.campaign.measure;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Point;
import arcomat.world.Recording;
import arcomat.world.Recording.Frame;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Measures beside numbers that a test takes from the recording of the same run by itself. */
class MeasuringTest {
    private static final String MEETING = "models/coffee/world/meeting.world";
    private static final String PLOUGH = "world/src/test/resources/world/plough/plough.world";
    private static SourceFile text;
    private static World world;
    private static PreparedWorld prepared;

    @BeforeAll
    static void prepare() throws IOException, WrongUse {
        text = text(MEETING);
        world = WorldParser.parse(text).world().orElseThrow();
        prepared = prepared(MEETING);
    }

    private static SourceFile text(String path) throws IOException {
        return new SourceFile(path, Files.readString(Path.of(path)));
    }

    private static PreparedWorld prepared(String path) throws WrongUse {
        PathNames names = new PathNames(Path.of("").toAbsolutePath());
        return new Session(names, Progress.NONE).run(new PrepareWorld(path, false));
    }

    private static Campaign campaign(String... lines) {
        String written =
                Stream.concat(Stream.of("world meeting.world", "sample random 1"), Stream.of(lines))
                        .collect(Collectors.joining("\n"));
        CampaignParser.Reading reading =
                CampaignParser.parse(new SourceFile("test.campaign", written));
        assertThat(reading.findings()).isEmpty();
        return reading.campaign().orElseThrow();
    }

    private static List<Double> answers(long seed, String... lines) {
        return answers(text, prepared, seed, lines);
    }

    private static List<Double> answers(
            SourceFile text, PreparedWorld prepared, long seed, String... lines) {
        Measuring measuring = Measuring.of(campaign(lines), text);
        assertThat(measuring.findings()).isEmpty();
        World world = WorldParser.parse(text).world().orElseThrow();
        Measuring.Run run = measuring.in(world).start();
        prepared.summarize(Seeds.of(seed), Laboratory.PATIENCE, Limits.OF_THE_BRICK, run);
        return run.answers();
    }

    @Test
    void numbersAreThoseOfTheRecording() {
        for (long seed : new long[] {1, 2, 7}) {
            Recording recording = prepared.run(seed);
            List<Frame> frames = recording.frames();
            double tenth =
                    2 * 400 * Recording.PERIOD / 1000.0; // mm that two robots may drive in it
            List<Double> answers =
                    answers(
                            seed,
                            "measure gap smallest loaded.x - empty.x",
                            "measure end last empty.x   # where it is in the end",
                            "measure far largest loaded.x",
                            "measure middle mean empty.y",
                            "measure waits seconds loaded.display == \"waiting\"",
                            "measure echo smallest loaded.S1",
                            "event backs when empty.display == \"backing\" && empty.cup == NONE",
                            "event flies when empty.y > 5000 || delivered == 1",
                            "measure end2 last time");
            assertThat(answers.get(0))
                    .isCloseTo(least(frames, f -> x(f, 1) - x(f, 0)), within(tenth));
            assertThat(answers.get(1)).isEqualTo(x(frames.get(frames.size() - 1), 0));
            assertThat(answers.get(2)).isCloseTo(-least(frames, f -> -x(f, 1)), within(1.0));
            double mean =
                    frames.stream()
                            .mapToDouble(f -> f.robots().get(0).pose().point().y())
                            .average()
                            .orElseThrow();
            assertThat(answers.get(3)).isCloseTo(mean, within(5.0));
            long waiting =
                    frames.stream()
                            .filter(f -> f.robots().get(1).display().equals("waiting"))
                            .count();
            assertThat(answers.get(4)).isCloseTo(waiting / 10.0, within(0.5));
            assertThat(answers.get(5))
                    .isLessThanOrEqualTo(least(frames, f -> f.robots().get(1).sensors().get(0)));
            assertThat(answers.subList(6, 9)).containsExactly(1.0, 0.0, 22.0);
        }
    }

    @Test
    void thingsAreReadWhereTheyLie() throws IOException, WrongUse {
        PreparedWorld ploughs = prepared(PLOUGH);
        List<Frame> frames = ploughs.run(1).frames();
        List<Double> answers =
                answers(
                        text(PLOUGH),
                        ploughs,
                        1,
                        "measure begin largest if time > 0.0 then 0.0 else box.x",
                        "measure end last box.x",
                        "measure high last box.y",
                        "event pushes when one.pushing",
                        "event early when one.pushing && time < 0.5",
                        "measure none last ball.x - ball.x");
        Point box = frames.get(frames.size() - 1).things().get(0);
        assertThat(box.x()).as("it was pushed").isGreaterThan(700);
        assertThat(answers).containsExactly(600.0, box.x(), box.y(), 1.0, 0.0, 0.0);
    }

    private static double x(Frame frame, int robot) {
        return frame.robots().get(robot).pose().point().x();
    }

    private static double least(
            List<Frame> frames, java.util.function.ToDoubleFunction<Frame> number) {
        return frames.stream().mapToDouble(number).min().orElseThrow();
    }

    @Test
    void whatIsUndefinedSaysNothing() {
        List<Double> answers =
                answers(
                        1,
                        "measure never largest 1.0 * (1 / (loaded.stock * 0))",
                        "event never2 when 1 / (loaded.stock * 0) == 1",
                        "measure never3 seconds 1 / (loaded.stock * 0) == 1",
                        "measure never4 mean loaded.x / (loaded.stock * 0)",
                        "measure sometimes largest if time > 1 then time else 0.0 / 0.0");
        assertThat(answers.subList(0, 4)).containsOnly(Double.NaN);
        assertThat(answers.get(4)).isEqualTo(22.0);
    }

    @Test
    void aRobotThatIsMissingWithSomeValuesSaysNothing() {
        SourceFile some =
                new SourceFile(
                        "some.world",
                        text.text()
                                .replace("robot loaded", "robots $n loaded")
                                .replace("with coffee", "with coffee step 0 200")
                                .replace("floor 5000", "parameter n 0\nfloor 5000"));
        Campaign campaign = campaign("vary n from 0 to 2 whole", "measure far largest loaded2.x");
        Measuring measuring = Measuring.of(campaign, some);
        assertThat(measuring.findings()).isEmpty();
        World without = WorldParser.parse(some).world().orElseThrow();
        Measuring.Run run = measuring.in(without).start();
        assertThat(run.answers()).containsExactly(Double.NaN);
    }

    @Test
    void mistakesAreFoundWhereTheyAre() {
        finds("measure gap smallest loaded.z - empty.x", "ARC0329", "z");
        finds("measure gap smallest box.x", "ARC0329", "box.x");
        finds("measure gap smallest loadd.x", "ARC0329", "loadd.x");
        finds("measure gap smallest loaded.x -   # nothing", "ARC1136", "");
        finds("measure gap smallest loaded.display", "ARC0316", "loaded.display");
        finds("measure gap smallest loaded", "ARC0316", "loaded");
        finds("measure gap seconds loaded.x", "ARC0315", "loaded.x");
        finds("event e when loaded.cup == SPILT", "ARC0329", "SPILT");
        finds("event e when loaded == empty", "ARC0330", "loaded == empty");
        finds("event e when loaded == loaded", "ARC1136", "loaded == loaded");
        finds("event e when time == --", "ARC1136", "time == --");
        finds("measure gap smallest --", "ARC1136", "--");
        finds("measure gap smallest alt {1, 2}", "ARC0311", "alt {1, 2}");
        String more = "1}; reading -> reading / {valueOfThisExpression = 2";
        finds("measure gap smallest " + more, "ARC1136", more);
    }

    private static void finds(String line, String code, String where) {
        List<Diagnostic> findings = Measuring.of(campaign(line), text).findings();
        assertThat(findings).as(line).hasSize(1);
        Diagnostic finding = findings.get(0);
        assertThat(finding.span().file().path()).isEqualTo("test.campaign");
        assertThat(finding.span().startPosition().line()).isEqualTo(3);
        assertThat(finding.code() + " " + finding.span().text())
                .as("%s: %s", line, finding.message())
                .isEqualTo(code + " " + where);
    }
}
