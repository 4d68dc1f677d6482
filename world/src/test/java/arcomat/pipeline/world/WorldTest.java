package arcomat.pipeline.world;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.generate.GenerateCode;
import arcomat.sim.Laboratory;
import arcomat.sim.device.Limits;
import arcomat.source.SourceFile;
import arcomat.world.Physics;
import arcomat.world.Recording;
import arcomat.world.Recording.Event;
import arcomat.world.Recording.Frame;
import arcomat.world.Recording.RobotFrame;
import arcomat.world.Scene.Happening.What;
import arcomat.world.Seeds;
import arcomat.world.World;
import arcomat.world.World.Cup;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.jar.Attributes;
import java.util.jar.JarOutputStream;
import java.util.jar.Manifest;
import java.util.stream.LongStream;

/** The scene of Fig. 1 and the whole service, with the jars that go on the brick. */
class WorldTest {
    private static final String FOLDER = "models/coffee/world/";
    private static final double LINE = 600;
    private static final double BODIES = 160;
    private static final long FEW = 20;
    private static final long SEEDS = 100;
    private static final double REAL_TIME = 200;

    private static World meeting;
    private static Map<String, WorldPrograms.Equipment> fetchers;
    private static World service;
    private static Map<String, WorldPrograms.Equipment> servants;

    @BeforeAll
    static void bringPrograms() throws IOException, WrongUse {
        meeting = world("meeting.world");
        fetchers = programs(meeting, "meeting.world");
        service = world("service.world");
        servants = programs(service, "service.world");
    }

    private static World world(String name) throws IOException {
        String text = Files.readString(Path.of(FOLDER, name));
        return WorldParser.parse(new SourceFile(FOLDER + name, text)).world().orElseThrow();
    }

    /** As long as usual, on bricks as they are. */
    private static Recording run(
            World world, long seed, Map<String, WorldPrograms.Equipment> equipment) {
        return run(world, Seeds.of(seed), equipment);
    }

    private static Recording run(
            World world, Seeds seeds, Map<String, WorldPrograms.Equipment> equipment) {
        WorldRecorder recorder = new WorldRecorder(world, seeds);
        WorldRun.run(world, seeds, equipment, Laboratory.PATIENCE, Limits.OF_THE_BRICK, recorder);
        return recorder.recording();
    }

    private static Map<String, WorldPrograms.Equipment> programs(World world, String name)
            throws WrongUse {
        PathNames names = new PathNames(Path.of("").toAbsolutePath());
        WorldPrograms.Result result =
                WorldPrograms.of(
                        world,
                        FOLDER + name,
                        false,
                        new Session(names, Progress.NONE),
                        new ProgramCache());
        assertThat(result.findings()).isEmpty();
        return result.equipment();
    }

    @Test
    void twoFetchersMeetAndPass() {
        LongStream.rangeClosed(1, FEW).forEach(WorldTest::meet);
    }

    @Test
    @Tag("slow")
    void twoFetchersMeetAndPassWhateverTheSeed() {
        LongStream.rangeClosed(FEW + 1, SEEDS).forEach(WorldTest::meet);
    }

    /** Fig. 1: who is empty makes room and comes back; who has coffee waits and passes. */
    private static void meet(long seed) {
        Recording run = run(meeting, seed, fetchers);
        assertThat(run.succeeded()).as("seed %d: %s", seed, run.failures()).isTrue();
        assertThat(run.count(What.COLLISION)).as("collisions with seed %d", seed).isZero();
        assertThat(shown(run, "empty"))
                .as("seed %d", seed)
                .containsExactly("driving", "backing", "remote", "returning", "driving");
        assertThat(shown(run, "loaded"))
                .as("seed %d", seed)
                .containsSubsequence("driving", "waiting", "driving")
                .containsOnly("driving", "waiting");

        Frame aside =
                run.frames()
                        .get(index(run, frame -> frame.robots().get(0).display().equals("remote")));
        RobotFrame empty = aside.robots().get(0);
        assertThat(Math.abs(empty.pose().y() - LINE)).as("off the line").isGreaterThan(BODIES);
        assertThat(empty.pose().y()).as("to its right").isLessThan(LINE);
        assertThat(empty.left()).as("waits").isBetween(-1.0, 1.0);

        for (Frame frame : run.frames()) {
            RobotFrame one = frame.robots().get(0);
            RobotFrame other = frame.robots().get(1);
            assertThat(one.pose().point().distance(other.pose().point()))
                    .as("seed %d, %d ms", seed, frame.time())
                    .isGreaterThan(BODIES);
            assertThat(other.cup()).isEqualTo(Cup.FULL);
            assertThat(Math.abs(other.pose().y() - LINE))
                    .as("who has coffee stays on the line, seed %d", seed)
                    .isLessThan(30);
        }
        Frame first = run.frames().get(0);
        Frame last = run.frames().get(run.frames().size() - 1);
        assertThat(first.robots().get(0).pose().x()).isLessThan(first.robots().get(1).pose().x());
        assertThat(last.robots().get(0).pose().x())
                .as("they have passed, seed %d", seed)
                .isGreaterThan(last.robots().get(1).pose().x() + 1000);
        for (RobotFrame robot : last.robots()) {
            assertThat(Math.abs(robot.pose().y() - LINE)).as("back on the line").isLessThan(30);
            assertThat(robot.left() + robot.right()).as("going on").isGreaterThan(150);
        }
    }

    private static List<String> shown(Recording run, String robot) {
        return run.events().stream()
                .filter(
                        event ->
                                event instanceof Event.Showed showed
                                        && showed.robot().equals(robot))
                .map(event -> ((Event.Showed) event).text())
                .toList();
    }

    private static int index(Recording run, java.util.function.Predicate<Frame> wanted) {
        for (int i = 0; i < run.frames().size(); i++) {
            if (wanted.test(run.frames().get(i))) {
                return i;
            }
        }
        throw new AssertionError("never seen");
    }

    /** Why package coffee.floor was written: see docs/world.md. */
    @Test
    void theFirstFetcherDoesNotMasterTheMeeting() throws WrongUse {
        SourceFile file = meeting.robots().get(0).place().file();
        String before = file.text().replace("coffee.floor.Courier", "coffee.fetcher.Fetcher");
        World world = WorldParser.parse(new SourceFile(file.path(), before)).world().orElseThrow();
        Recording run = run(world, 1, programs(world, "meeting.world"));
        List<RobotFrame> last = run.frames().get(run.frames().size() - 1).robots();
        assertThat(last).allMatch(robot -> Math.abs(robot.left()) < 1);
        assertThat(last.get(0).pose().x()).as("not passed").isLessThan(last.get(1).pose().x());
    }

    /** Cups travel from hand to hand: three programs, and Bluetooth between two of them. */
    @Tag("slow")
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void threeRobotsServeTenCupsToThreeDrinkers(long seed) {
        serve(seed);
    }

    private static void serve(long seed) {
        Recording run = run(service, seed, servants);
        assertThat(run.succeeded()).as("%s", run.failures()).isTrue();
        assertThat(run.delivered()).isEqualTo(10);
        assertThat(run.count(What.CUP_GIVEN)).isEqualTo(10);
        assertThat(run.count(What.COFFEE_POURED)).isEqualTo(10);
        assertThat(run.count(What.CUP_LOST) + run.count(What.COFFEE_SPILT)).isZero();
        Frame last = run.frames().get(run.frames().size() - 1);
        assertThat(last.drinkers()).hasSize(3).allMatch(drinker -> drinker.cups() >= 3);
        assertThat(run.events().stream().filter(Event.Sent.class::isInstance))
                .as("hold and go, for each cup")
                .hasSize(20);
    }

    /** What 'generate' has written runs as well as what is made on the spot. */
    @Test
    void jarsOfTheOutputFolderRun(@TempDir Path folder) throws IOException, WrongUse {
        Session session = Session.in(folder, Progress.NONE);
        Path models = Path.of("models/coffee").toAbsolutePath();
        session.run(
                new GenerateCode(
                        "lejos",
                        "brick",
                        Optional.of("coffee.floor.Courier"),
                        false,
                        List.of(),
                        List.of(models.toString())));
        String text = meeting.robots().get(0).place().file().text();
        String jars =
                text.replace("parameter fetcher coffee.floor.Courier", "")
                        .replace("component $fetcher in ..", "jar brick/Courier.jar");
        Files.writeString(folder.resolve("jars.world"), jars);
        PreparedWorld prepared = session.run(new PrepareWorld("jars.world", false));
        assertThat(prepared.findings()).isEmpty();
        assertThat(prepared.run(7).events()).isEqualTo(run(meeting, 7, fetchers).events());

        Path hollow = folder.resolve("brick/Hollow.jar");
        Manifest manifest = new Manifest();
        manifest.getMainAttributes().put(Attributes.Name.MANIFEST_VERSION, "1.0");
        manifest.getMainAttributes().put(Attributes.Name.MAIN_CLASS, "p.Main");
        new JarOutputStream(Files.newOutputStream(hollow), manifest).close();
        Files.writeString(folder.resolve("jars.world"), jars.replace("Courier.jar", "Hollow.jar"));
        assertThat(session.run(new PrepareWorld("jars.world", false)).findings())
                .singleElement()
                .satisfies(
                        finding ->
                                assertThat(finding.message())
                                        .contains("names the main class p.Main")
                                        .contains("does not contain it"));
    }

    @Test
    void theSameSeedGivesTheSameRun() {
        Recording one = run(meeting, 7, fetchers);
        Recording again = run(meeting, 7, fetchers);
        assertThat(again).isEqualTo(one);
        assertThat(run(meeting, 8, fetchers).frames()).isNotEqualTo(one.frames());
    }

    /** Before that, nobody can tell: the same readings, places and displays, to the bit. */
    @ParameterizedTest
    @ValueSource(longs = {1, 7, 23})
    void runsPartWhereTheirSeedsDo(long seed) {
        int tick = 800;
        Recording one = run(meeting, Seeds.of(seed).then(tick, 77), fetchers);
        Recording other = run(meeting, Seeds.of(seed).then(tick, 78), fetchers);
        int frames = tick * Physics.STEP / Recording.PERIOD;
        assertThat(one.frames().subList(0, frames))
                .isEqualTo(other.frames().subList(0, frames))
                .isEqualTo(run(meeting, seed, fetchers).frames().subList(0, frames));
        assertThat(one.frames().get(frames).robots())
                .extracting(RobotFrame::pose)
                .isEqualTo(
                        other.frames().get(frames).robots().stream()
                                .map(RobotFrame::pose)
                                .toList());
        assertThat(one.frames()).isNotEqualTo(other.frames());
        assertThat(run(meeting, one.seeds(), fetchers)).isEqualTo(one);
    }

    /**
     * The bound is lenient: the machine may be busy. docs/performance.md says what was measured.
     */
    @Test
    @Tag("slow")
    void theMeetingRunsMuchFasterThanRealTime() {
        long best = Long.MAX_VALUE;
        for (int i = 0; i < 20; i++) {
            long start = System.nanoTime();
            run(meeting, i, fetchers);
            best = Math.min(best, System.nanoTime() - start);
        }
        assertThat(meeting.seconds() * 1e9 / best).isGreaterThan(REAL_TIME);
    }
}
