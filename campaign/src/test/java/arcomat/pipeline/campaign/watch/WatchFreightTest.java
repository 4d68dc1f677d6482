package arcomat.pipeline.campaign.watch;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.Row;
import arcomat.campaign.Trials;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.PrepareCampaign;
import arcomat.pipeline.campaign.PrepareCampaign.Prepared;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Probe;
import arcomat.source.SourceFile;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.LongStream;

/**
 * A rover that sees a wall in time, or does not: what its monitor says is what its display says.
 */
class WatchFreightTest {
    private static final String FOLDER = "campaign/src/test/resources/campaign/watch";

    private static Prepared prepared(Path folder, String file) throws WrongUse {
        Session session = new Session(new PathNames(folder.toAbsolutePath()), Progress.NONE);
        return session.run(
                new PrepareCampaign(file, Limits.OF_THE_BRICK, Duration.ofMinutes(1), "1"));
    }

    @Test
    void aViolationIsAnEvent() throws WrongUse, IOException {
        Prepared prepared = prepared(Path.of(FOLDER), "yard.campaign");
        assertThat(prepared.findings()).isEmpty();
        Campaign campaign = prepared.ready().orElseThrow().campaign();
        Freight freight = prepared.ready().orElseThrow().freight();
        Trials trials = Trials.of(campaign);
        TrialRunner runner = new TrialRunner(Freight.unpacked(freight.packed()));
        List<Row> rows =
                LongStream.range(0, trials.count()).mapToObj(trials::trial).map(runner).toList();
        int near = campaign.column("near");
        int stands = campaign.column("stands");
        assertThat(rows).allMatch(Row::wasMade);
        assertThat(rows).allMatch(row -> row.happened(stands) || !row.happened(near));
        // What a requirement without outputs forbids is seen when the next slice begins.
        assertThat(rows)
                .filteredOn(row -> row.answer(campaign.column("first")) < 6.85)
                .allMatch(row -> row.happened(near));
        assertThat(rows).anyMatch(row -> row.happened(near)).anyMatch(row -> !row.happened(near));
        assertThat(rows).noneMatch(row -> row.happened(campaign.column("blind")));
    }

    /** Whoever looks, a program does the same at the same time. */
    @Test
    void probesChangeNothing() throws WrongUse {
        Freight freight =
                prepared(Path.of(FOLDER), "yard.campaign").ready().orElseThrow().freight();
        World world =
                WorldParser.parse(new SourceFile("yard.world", freight.world()))
                        .world()
                        .orElseThrow();
        Map.Entry<String, arcomat.sim.load.Program> only =
                freight.programs().entrySet().iterator().next();
        List<Probe> probes =
                only.getValue().classes().keySet().stream()
                        .flatMap(
                                type ->
                                        List.of("slice", "step", "judge", "see", "run").stream()
                                                .map(method -> new Probe(type, method)))
                        .toList();
        PreparedWorld plain =
                PreparedWorld.of(
                        world, Map.of(only.getKey(), LoadedProgram.forMany(only.getValue())));
        PreparedWorld probed =
                PreparedWorld.of(
                        world,
                        Map.of(
                                only.getKey(),
                                LoadedProgram.forMany(only.getValue(), probes, List.of())));
        for (long seed = 1; seed <= 5; seed++) {
            assertThat(probed.run(seed)).isEqualTo(plain.run(seed));
        }
    }

    @ParameterizedTest
    @CsvSource({
        "mind=yard.Nothing, there is no component 'yard.Nothing'",
        "wheel=yard.Far, yard.Rover has no part 'wheel' to be watched for 'yard.Far'",
        "yard.Far, nothing in yard.Rover says that it keeps 'yard.Far'",
    })
    void whatCannotBeWatchedIsTold(String requirement, String message, @TempDir Path folder)
            throws IOException, WrongUse {
        Files.createDirectory(folder.resolve("yard"));
        for (String each : List.of("yard.world", "yard/Rover.arc", "yard/Far.arc")) {
            Files.copy(Path.of(FOLDER, each), folder.resolve(each));
        }
        Files.writeString(
                folder.resolve("a.campaign"),
                "world yard.world\nsample random 1\nwatch near " + requirement + "\n");
        Prepared prepared = prepared(folder, "a.campaign");
        assertThat(prepared.findings()).hasSize(1);
        assertThat(prepared.findings().get(0).code()).isEqualTo("ARC1137");
        assertThat(prepared.findings().get(0).span().text()).isEqualTo(requirement);
        assertThat(prepared.findings().get(0).message()).startsWith(message);
    }
}
