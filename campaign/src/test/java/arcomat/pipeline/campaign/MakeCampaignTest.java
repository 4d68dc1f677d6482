package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Quantity;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.Coverage;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.campaign.coverage.PartItems;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.campaign.statistics.Decision;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.MakeCampaign.Made;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.function.Function;

/** Runs whose answers are known: every tenth seed collides. */
class MakeCampaignTest {
    private static final String TEXT = "world a.world\nsample random 500\n";

    private static final CoverageItems ITEMS =
            new CoverageItems(
                    List.of(
                            new AutomatonItems(
                                    "p.Lamp",
                                    "p/Lamp.arc",
                                    List.of(
                                            new AutomatonItems.Transition(5, "off -> on", 1, true),
                                            new AutomatonItems.Transition(6, "on -> off", 0, true),
                                            new AutomatonItems.Transition(7, "on -> on", 1, true)),
                                    List.of(
                                            new AutomatonItems.State(3, "off"),
                                            new AutomatonItems.State(3, "on")),
                                    List.of(0))),
                    List.of(new PartItems("one", "lamp", 0), new PartItems("other", "lamp", 0)),
                    List.of());

    @TempDir private Path folder;

    private static Row answer(Trial trial) {
        List<Double> answers =
                Arrays.stream(Quantity.values())
                        .map(each -> each == Quantity.COLLISION ? hit(trial) : trial.seed() * 0.5)
                        .toList();
        BitSet reached = new BitSet();
        reached.set(0, trial.seed() % 50 == 3);
        reached.set(1, trial.seed() > 490);
        reached.set(3);
        reached.set(4, trial.seed() % 50 == 3); // by one
        reached.set(9, trial.seed() > 490); // by the other
        return Row.made(trial, answers, ReachedItems.of(reached));
    }

    private static double hit(Trial trial) {
        return trial.seed() % 10 == 0 ? 1 : 0;
    }

    /** Gives rows as it likes, most of them late and out of order. */
    private static final class Careless implements Engine {
        private final Random random;
        private final List<Trial> given = new ArrayList<>();
        private int asked;

        Careless(long seed) {
            random = new Random(seed);
        }

        @Override
        public int capacity() {
            return 1 + random.nextInt(7);
        }

        @Override
        public void submit(List<Trial> batch) {
            given.addAll(batch);
            asked += batch.size();
            Collections.shuffle(given, random);
        }

        @Override
        public List<Row> collect(Duration patience) {
            int count = Math.min(given.size(), random.nextInt(4));
            List<Trial> now = List.copyOf(given.subList(0, count));
            given.subList(0, count).clear();
            return now.stream().map(MakeCampaignTest::answer).toList();
        }

        @Override
        public String crew() {
            return "somebody";
        }

        @Override
        public void close() {}
    }

    private static PrepareCampaign.Ready ready(String text) {
        Campaign campaign =
                CampaignParser.parse(new SourceFile("a.campaign", text)).campaign().orElseThrow();
        Freight freight = new Freight("1", text, "", true, Duration.ofSeconds(300), Map.of());
        return new PrepareCampaign.Ready(campaign, "a.world", freight, ITEMS, List.of(), List.of());
    }

    private Made make(String text, String results, boolean resumes, Engine engine) throws WrongUse {
        Function<Freight, Engine> engines = content -> engine;
        return Session.in(folder, Progress.NONE)
                .run(new MakeCampaign(ready(text), results, resumes, engines));
    }

    private MakePart.Made makePart(String part, boolean resumes, Engine engine) throws WrongUse {
        CampaignPart which = CampaignPart.parse(part);
        return Session.in(folder, Progress.NONE)
                .run(
                        new MakePart(
                                ready(TEXT),
                                which,
                                "part" + which.number(),
                                resumes,
                                content -> engine));
    }

    private Made together(String text, List<String> parts, Engine engine) throws WrongUse {
        Session session = Session.in(folder, Progress.NONE);
        PrepareCampaign.Ready ready = ready(text);
        Function<Freight, Engine> engines =
                StoredRows.engines(parts, ready, content -> engine, session);
        return session.run(new MakeCampaign(ready, "together", false, engines));
    }

    /** Three parts of 500 runs, made by several, one of which was interrupted. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void partsAreTogetherTheWhole(long seed) throws Exception {
        Made whole = make(TEXT, "whole", false, new Careless(seed));
        assertThat(makePart("1/3", false, new Careless(seed + 1)).end()).isEqualTo(166);
        assertThatThrownBy(() -> makePart("2/3", false, dying(20))).hasMessage("the power is gone");
        assertThatThrownBy(() -> together(TEXT, List.of("part2"), new Careless(seed)))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining("has not come to its end");
        assertThat(makePart("2/3", true, new Careless(seed + 2)).first()).isEqualTo(166);
        makePart("3/3", false, new Careless(seed + 3));
        Made together =
                together(TEXT, List.of("part3", "part1", "part2"), new ThreadEngine(1, nobody()));
        assertThat(together.table()).isEqualTo(whole.table());
        assertThat(together.result()).isEqualTo(whole.result());
        assertThat(together.coverage()).isEqualTo(whole.coverage());
        assertThat(folder.resolve("together/rows.parquet"))
                .hasSameBinaryContentAs(folder.resolve("whole/rows.parquet"));
    }

    @Test
    void whatNoPartHasIsMade() throws Exception {
        Made whole = make(TEXT, "whole", false, new Careless(1));
        makePart("2/3", false, new Careless(2));
        Careless rest = new Careless(3);
        assertThat(together(TEXT, List.of("part2", "part2"), rest).table())
                .isEqualTo(whole.table());
        assertThat(rest.asked).isEqualTo(500 - 167);
    }

    private static Function<Trial, Row> nobody() {
        return trial -> {
            throw new IllegalStateException("all rows are there");
        };
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theTableDoesNotDependOnWhoMakesTheRunsAndInWhichOrder(long seed) throws Exception {
        Made one = make(TEXT, "one", false, new ThreadEngine(1, MakeCampaignTest::answer));
        Made other = make(TEXT, "other", false, new Careless(seed));
        assertThat(other.table()).isEqualTo(one.table());
        assertThat(folder.resolve("other/rows.csv"))
                .hasSameTextualContentAs(folder.resolve("one/rows.csv"));
        assertThat(one.result().occurrences().get(0).runs()).isEqualTo(50);
        assertThat(other.coverage()).isEqualTo(one.coverage());
        Coverage.OfAutomaton lamp = one.coverage().automata().get(0);
        assertThat(lamp.transitions()).containsExactly(10L, 10L, 0L);
        assertThat(lamp.states()).containsExactly(500L, 10L);
        assertThat(lamp.parts().get(0).transitions()).containsExactly(10L, 0L, 0L);
        assertThat(lamp.parts().get(1).transitions()).containsExactly(0L, 10L, 0L);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void whereItStopsDoesNotDependOnIt(long seed) throws Exception {
        String text = TEXT + "stop decided\nrequire collision below 0.3 at 99\n";
        Made one = make(text, "", false, new ThreadEngine(2, MakeCampaignTest::answer));
        Made other = make(text, "", false, new Careless(seed));
        assertThat(one.runs()).isLessThan(500);
        assertThat(one.result().judgements().get(0).decision()).isEqualTo(Decision.HOLDS);
        assertThat(other.table()).isEqualTo(one.table());
        // Runs behind that are nobody's: they cover nothing.
        assertThat(other.coverage()).isEqualTo(one.coverage());
        assertThat(one.coverage().runs()).isEqualTo(one.runs());
        assertThat(one.coverage().taken()).isEqualTo(1);
    }

    /** As if it had been killed after some rows, and in the middle of a line. */
    @ParameterizedTest
    @ValueSource(ints = {0, 1, 17, 499})
    void anInterruptedCampaignGoesOn(int rows) throws Exception {
        Made whole = make(TEXT, "whole", false, new Careless(7));
        assertThatThrownBy(() -> make(TEXT, "part", false, dying(rows)))
                .isInstanceOf(WrongUse.class)
                .hasMessage("the power is gone");
        Path unfinished = folder.resolve("part/rows.unfinished");
        Files.writeString(unfinished, "499,500,ma", StandardOpenOption.APPEND);
        assertThatThrownBy(() -> make(TEXT, "part", false, new Careless(8)))
                .hasMessageContaining("go on with --resume");
        Made resumed = make(TEXT, "part", true, new Careless(9));
        assertThat(resumed.table()).isEqualTo(whole.table());
        assertThat(resumed.result()).isEqualTo(whole.result());
        assertThat(resumed.coverage()).isEqualTo(whole.coverage());
        assertThat(folder.resolve("part/rows.csv"))
                .hasSameTextualContentAs(folder.resolve("whole/rows.csv"));
        assertThat(unfinished).doesNotExist();
    }

    /** Gives some rows, in order, and fails. */
    private static Engine dying(int rows) {
        return new Engine() {
            private final List<Trial> given = new ArrayList<>();
            private int made;

            @Override
            public int capacity() {
                return 100;
            }

            @Override
            public void submit(List<Trial> batch) {
                given.addAll(batch);
            }

            @Override
            public List<Row> collect(Duration patience) {
                if (made == rows) {
                    throw new EngineFailure("the power is gone");
                }
                return List.of(answer(given.get(made++)));
            }

            @Override
            public String crew() {
                return "a candle";
            }

            @Override
            public void close() {}
        };
    }

    @Test
    void rowsOfAnotherCampaignAreNotMixedIn() throws IOException {
        assertThatThrownBy(() -> make(TEXT, "part", false, dying(3))).isInstanceOf(WrongUse.class);
        String other = TEXT.replace("500", "600");
        assertThatThrownBy(() -> make(other, "part", true, new Careless(1)))
                .isInstanceOf(WrongUse.class)
                .hasMessageContaining("belong to another campaign");
        assertThat(Files.readAllLines(folder.resolve("part/rows.unfinished"))).hasSize(4);
    }

    @Test
    void aRunThatWasGivenUpCountsAgainstWhatIsAskedFor() throws Exception {
        String text = TEXT + "require collision below 0.01 at 95\n";
        Engine engine =
                new ThreadEngine(
                        1,
                        trial ->
                                trial.number() < 20
                                        ? Row.withoutAnswers(trial, Row.Ending.GIVEN_UP, "late")
                                        : Row.made(
                                                trial,
                                                Collections.nCopies(
                                                        Quantity.values().length, 0.0)));
        Made made = make(text, "", false, engine);
        assertThat(made.result().givenUp()).isEqualTo(20);
        assertThat(made.result().judgements().get(0).decision()).isEqualTo(Decision.FAILS);
    }

    @Test
    void aFaultOfOursIsNoRow() {
        Engine engine =
                new ThreadEngine(
                        1,
                        trial -> {
                            throw new IllegalStateException("a fault");
                        });
        assertThatThrownBy(() -> make(TEXT, "", false, engine)).hasRootCauseMessage("a fault");
    }
}
