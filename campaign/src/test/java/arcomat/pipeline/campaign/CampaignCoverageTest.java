package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.Quantity;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.campaign.coverage.ItemNumbers;
import arcomat.campaign.coverage.PartItems;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ProgramItems;
import arcomat.pipeline.campaign.engine.ProgramItems.OfClass;
import arcomat.pipeline.campaign.engine.TrialRunner;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.NotedLines;
import arcomat.source.SourceFile;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.BitSet;
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
                            ProgramItems items = ready.freight().coverage().programs().get(key);
                            List<NotedLines> lines =
                                    items.automata().stream().map(OfClass::lines).toList();
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
    @Tag("slow")
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
            assertThat(row.reached().contains(items.ofAutomaton(i).initial())).isTrue();
        }
    }

    /**
     * What several parts have covered together is what an automaton has. The two fetchers have the
     * same parts, and do not do the same: one of them has coffee.
     */
    @Test
    void partsAreThoseOfTheRobots() {
        CoverageItems items = ready.items();
        assertThat(items.parts().stream().map(PartItems::name))
                .doesNotHaveDuplicates()
                .contains("empty.avoidCrash", "loaded.avoidCrash");
        Row row = new TrialRunner(ready.freight()).apply(Trials.of(ready.campaign()).trial(0));
        List<ItemNumbers> numbers = items.ofParts();
        Map<Integer, BitSet> together = new TreeMap<>();
        for (int i = 0; i < numbers.size(); i++) {
            PartItems part = items.parts().get(i);
            BitSet taken = taken(row, numbers.get(i), items.automata().get(part.automaton()));
            assertThat(row.reached().contains(numbers.get(i).initial())).isTrue();
            together.computeIfAbsent(part.automaton(), a -> new BitSet()).or(taken);
        }
        for (int i = 0; i < items.automata().size(); i++) {
            assertThat(taken(row, items.ofAutomaton(i), items.automata().get(i)))
                    .isEqualTo(together.get(i));
        }
        assertThat(taken(row, items, "empty.avoidCrash"))
                .isNotEqualTo(taken(row, items, "loaded.avoidCrash"));
    }

    private static BitSet taken(Row row, CoverageItems items, String name) {
        List<String> names = items.parts().stream().map(PartItems::name).toList();
        PartItems part = items.parts().get(names.indexOf(name));
        ItemNumbers numbers = items.ofParts().get(names.indexOf(name));
        return taken(row, numbers, items.automata().get(part.automaton()));
    }

    private static BitSet taken(Row row, ItemNumbers numbers, AutomatonItems automaton) {
        BitSet taken = new BitSet();
        for (int i = 0; i < automaton.transitions().size(); i++) {
            taken.set(i, row.reached().contains(numbers.transition() + i));
        }
        return taken;
    }
}
