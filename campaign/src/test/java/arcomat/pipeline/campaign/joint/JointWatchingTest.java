package arcomat.pipeline.campaign.joint;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;
import arcomat.campaign.Trials;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.PrepareCampaign.Ready;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.world.Onlooker;
import arcomat.sim.device.Limits;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Physics;
import arcomat.world.Scene;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;

/** Two lamps that are on and off in slices that are known. */
class JointWatchingTest {
    private static final Path FOLDER = Path.of("campaign/src/test/resources/campaign/joint");

    private static Ready ready(String file) throws WrongUse {
        Session session = new Session(new PathNames(FOLDER.toAbsolutePath()), Progress.NONE);
        PrepareCampaign.Prepared prepared =
                session.run(
                        new PrepareCampaign(file, Limits.OF_THE_BRICK, Duration.ofMinutes(1), "1"));
        assertThat(prepared.findings()).noneMatch(Diagnostic::isError);
        return prepared.ready().orElseThrow();
    }

    private static List<Row> rows(Ready ready) throws IOException {
        Trials trials = Trials.of(ready.campaign());
        TrialRunner runner = new TrialRunner(Freight.unpacked(ready.freight().packed()));
        return LongStream.range(0, trials.count()).mapToObj(trials::trial).map(runner).toList();
    }

    private static int from(Row row) {
        return Integer.parseInt(row.trial().values().get("from"));
    }

    @Tag("slow")
    @Test
    void whatTwoRobotsDoIsKnownByConstruction() throws WrongUse, IOException {
        Ready ready = ready("yard.campaign");
        Campaign campaign = ready.campaign();
        List<Row> rows = rows(ready);
        assertThat(rows).hasSize(60).allMatch(Row::wasMade);
        for (Row row : rows) {
            boolean overlap = from(row) < 20;
            assertThat(row.happened(campaign.column("both"))).isEqualTo(overlap);
            // The same question, once as a requirement and once as an expression.
            assertThat(row.happened(campaign.column("seen"))).isEqualTo(overlap);
            assertThat(row.happened(campaign.column("shown"))).isEqualTo(overlap);
            // From slice 10 of the first to slice 22, 30 or 40 of the second, which begin later.
            boolean soon = from(row) >= 22;
            assertThat(row.happened(campaign.column("soon"))).isEqualTo(!soon);
            assertThat(row.happened(campaign.column("echo"))).isFalse();
            assertThat(row.happened(campaign.column("sooner"))).isTrue();
            assertThat(row.happened(campaign.column("same"))).isFalse();
            assertThat(row.happened(campaign.column("other"))).isTrue();
            // Nobody knows what a robot does that is not there.
            boolean third = row.trial().values().get("more").equals("1");
            int column = campaign.column("third");
            assertThat(row.answers(column)).isEqualTo(third);
            assertThat(third && row.happened(column)).isEqualTo(third && overlap);
        }
    }

    @Test
    void whatIsNoValueOfThePortIsNotKnown() throws WrongUse, IOException {
        assertThat(rows(ready("small.campaign")))
                .allMatch(row -> !row.wasMade())
                .allMatch(row -> row.remark().contains("small: at 1."))
                .allMatch(
                        row ->
                                row.remark()
                                        .endsWith(
                                                "'value' has no value: 101 is no Integer[0..100]"));
    }

    @Test
    void whatWatchesTravels() throws WrongUse, IOException {
        JointFreight joint = ready("yard.campaign").freight().joint();
        JointFreight back = JointFreight.of(joint.entries());
        assertThat(back.requirements()).isEqualTo(joint.requirements());
        assertThat(back.programs()).isEqualTo(joint.programs());
        assertThat(back.classes().keySet()).isEqualTo(joint.classes().keySet());
        back.classes()
                .forEach((name, code) -> assertThat(code).isEqualTo(joint.classes().get(name)));
        assertThat(JointFreight.NONE.entries()).isEmpty();
    }

    /** What a program of the tool looks like to who watches it. */
    public static final class FakeBeacon {
        public final FakeLamp lamp = new FakeLamp();
    }

    /** Its part; 0 is no message. */
    public static final class FakeLamp {
        public int light;
    }

    /**
     * Robots whose slices are a text, one letter each: {@code 1} is on, {@code 0} is off, {@code -}
     * is nothing, {@code |} is a moment of the world.
     */
    @ParameterizedTest
    @CsvSource({
        // In turn, moment by moment.
        "1|0|-|-|, -|-|1|0|, false",
        // Each robot on its own makes no slice that the other one has to have, too.
        "1||0||||, ||||1||, false",
        "1||||0||, |||1|||, true",
        // What ends in the same moment is the same slice.
        "1|0|-|, -|1|-|, false",
        "1|-|0|, -|1|-|, true",
        // A robot that is late makes several slices at once: all of them are seen, in their order.
        "1|-|, -|-1|, true",
        "10|--|, -|1|, false",
        "10|--|, -1|--|, false",
        "101|, -|, false",
        "11|, -|, true",
        // The last moment counts.
        "1|, 1|, true",
        "-|1|, -|1|, true",
        // What ends after the last moment does not.
        "1|, -|1, false",
    })
    void slicesAreSeenAtTheMomentAfterTheirEnd(String one, String two, boolean violated)
            throws WrongUse {
        Ready ready = ready("both.campaign");
        JointFreight real = ready.freight().joint();
        PortTap tap = new PortTap("lamp.light", "lamp", "light", "", true, false);
        ProgramTaps taps = new ProgramTaps(FakeBeacon.class.getName(), List.of(tap));
        SourceFile text = new SourceFile("yard.world", ready.freight().world());
        World world = WorldParser.parse(text, Map.of()).world().orElseThrow();
        JointFreight fake =
                new JointFreight(
                        real.classes(),
                        real.requirements(),
                        Map.of(
                                world.robots().get(0).kind().program().key(), taps,
                                world.robots().get(1).kind().program().key(), taps));
        JointRun run =
                JointWatching.of(fake, ready.campaign(), text).in(world).start(Onlooker.NOBODY);
        Scene scene = new Physics(world, 1).start();
        String[] first = one.split("\\|", -1);
        String[] second = two.split("\\|", -1);
        FakeBeacon left = new FakeBeacon();
        FakeBeacon right = new FakeBeacon();
        for (int moment = 0; moment < first.length; moment++) {
            first[moment].chars().forEach(letter -> step(run, "one", left, letter));
            second[moment].chars().forEach(letter -> step(run, "two", right, letter));
            if (moment < first.length - 1) {
                run.see(scene, null);
            }
        }
        run.end();
        assertThat(run.doubt()).isEmpty();
        assertThat(run.answers()).containsExactly(violated ? 1.0 : 0.0);
    }

    private static void step(JointRun run, String robot, FakeBeacon beacon, int letter) {
        run.entered(robot, beacon, "step");
        beacon.lamp.light = letter == '1' ? 1 : letter == '0' ? 2 : 0;
        run.left(robot, beacon, "step");
    }
}
