package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.Quantity;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LineProbe;
import arcomat.sim.load.LoadedProgram;
import arcomat.source.SourceFile;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.LongStream;

/** Two robots of the case study meet: probes see what they do, and change nothing. */
class CampaignCoverageTest {
    @TempDir private static Path folder;

    private static PrepareCampaign.Ready ready;

    @BeforeAll
    static void prepare() throws WrongUse, IOException {
        Path world = Path.of("models/coffee/world/meeting.world").toAbsolutePath();
        String text = "world " + world + "\nvary light from 0 to 3\nsample random 6\n";
        Files.writeString(folder.resolve("a.campaign"), text);
        ready =
                Session.in(folder, Progress.NONE)
                        .run(
                                new PrepareCampaign(
                                        "a.campaign",
                                        Limits.OF_THE_BRICK,
                                        Duration.ofMinutes(1),
                                        "1"))
                        .ready()
                        .orElseThrow();
    }

    private static PreparedWorld prepared(World world, boolean probed) {
        Map<String, LoadedProgram> programs = new TreeMap<>();
        ready.freight()
                .programs()
                .forEach(
                        (key, each) -> {
                            List<LineProbe> lines = ready.freight().coverage().programs().get(key);
                            programs.put(
                                    key,
                                    LoadedProgram.forMany(
                                            each, List.of(), probed ? lines : List.of()));
                        });
        return PreparedWorld.of(world, programs);
    }

    @Test
    void probesChangeNothing() {
        SourceFile text = new SourceFile("world", ready.freight().world());
        World world = WorldParser.parse(text).world().orElseThrow();
        PreparedWorld plain = prepared(world, false);
        PreparedWorld probed = prepared(world, true);
        for (long seed = 1; seed <= 5; seed++) {
            assertThat(probed.run(seed)).isEqualTo(plain.run(seed));
        }
    }

    /** Nothing of one run is seen in the next one, whoever makes them in which order. */
    @Test
    void rowsDoNotDependOnWhoMakesThem() throws IOException {
        Campaign campaign = ready.campaign();
        Trials trials = Trials.of(campaign);
        List<Trial> all = LongStream.range(0, 6).mapToObj(trials::trial).toList();
        List<Row> rows = all.stream().map(new TrialRunner(ready.freight())).toList();
        TrialRunner elsewhere = new TrialRunner(Freight.unpacked(ready.freight().packed()));
        List<Trial> mixed = new ArrayList<>(all);
        Collections.shuffle(mixed, new Random(1));
        mixed.forEach(elsewhere::apply);
        assertThat(all.stream().map(elsewhere).toList()).isEqualTo(rows);
        int transitions = campaign.column(Quantity.TRANSITIONS.word());
        for (Row row : rows) {
            assertThat(row.answer(transitions))
                    .isBetween(10.0, (double) ready.items().transitions())
                    .isEqualTo(row.reached().countBelow(ready.items().transitions()));
        }
        assertThat(rows.stream().map(Row::reached).distinct()).hasSizeGreaterThan(1);
    }

    /** Every automaton of the robots is there, once, and begins. */
    @Test
    void itemsAreThoseOfTheModels() {
        CoverageItems items = ready.items();
        assertThat(items.automata().stream().map(AutomatonItems::component))
                .doesNotHaveDuplicates()
                .contains("coffee.fetcher.CupHolder");
        Row row = new TrialRunner(ready.freight()).apply(Trials.of(ready.campaign()).trial(0));
        for (int i = 0; i < items.automata().size(); i++) {
            AutomatonItems each = items.automata().get(i);
            assertThat(each.transitions()).allMatch(AutomatonItems.Transition::coded);
            assertThat(row.reached().contains(items.initial(i, 0))).isTrue();
        }
    }
}
