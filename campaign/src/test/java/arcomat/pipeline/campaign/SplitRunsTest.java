package arcomat.pipeline.campaign;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.RareEvent;
import arcomat.campaign.Row;
import arcomat.campaign.TableText;
import arcomat.campaign.Trial;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.Freight;
import arcomat.pipeline.campaign.engine.ThreadEngine;
import arcomat.source.SourceFile;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;

/** Runs whose answers are known: every third seed comes to its level, a second after the last. */
class SplitRunsTest {
    private static final String TEXT =
            "world a.world\nsample random 5\nsplit on distance levels 30 20 10 runs 90\n";
    private static final Campaign CAMPAIGN =
            CampaignParser.parse(new SourceFile("a.campaign", TEXT)).campaign().orElseThrow();

    @TempDir private Path folder;

    private static Row answer(Trial trial) {
        int level = trial.seeds().changes().size();
        long last = level == 0 ? trial.seed() : trial.seeds().changes().get(level - 1).seed();
        int reached = last % 3 == 0 ? level + 1 : level;
        List<Double> answers = new ArrayList<>();
        CAMPAIGN.columns().forEach(column -> answers.add(0.0));
        answers.set(CAMPAIGN.column("distance"), (double) last);
        for (int i = 0; i < 3; i++) {
            double seconds = i < reached ? i + 1 : Double.POSITIVE_INFINITY;
            answers.set(CAMPAIGN.column("within_" + (30 - 10 * i)), seconds);
        }
        return Row.made(trial, answers);
    }

    /** Gives rows as it likes, and only after they have been text. */
    private static final class Careless implements Engine {
        private final Random random;
        private final TableText text = new TableText(CAMPAIGN);
        private final List<Trial> given = new ArrayList<>();

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
            Collections.shuffle(given, random);
        }

        @Override
        public List<Row> collect(Duration patience) {
            int count = Math.min(given.size(), random.nextInt(4));
            List<Trial> now = List.copyOf(given.subList(0, count));
            given.subList(0, count).clear();
            return now.stream().map(trial -> text.row(text.line(answer(trial)))).toList();
        }

        @Override
        public String crew() {
            return "somebody";
        }

        @Override
        public void close() {}
    }

    private Optional<RareEvent> split(Engine engine) throws WrongUse {
        Freight freight = new Freight("1", TEXT, "", true, Duration.ofSeconds(300), Map.of());
        PrepareCampaign.Ready ready =
                new PrepareCampaign.Ready(
                        CAMPAIGN, "a.world", freight, CoverageItems.NONE, List.of(), List.of());
        return Session.in(folder, Progress.NONE).run(new SplitRuns(ready, content -> engine));
    }

    @Test
    void allLevelsAreTried() throws Exception {
        RareEvent event = split(new ThreadEngine(2, SplitRunsTest::answer)).orElseThrow();
        assertThat(event.levels()).hasSize(3).allMatch(level -> level.reached() == 30);
        assertThat(event.runs()).isEqualTo(270);
        assertThat(event.estimate()).isCloseTo(1 / 27.0, org.assertj.core.data.Offset.offset(1e-9));
        assertThat(event.nearest().orElseThrow().row().trial().seeds().text()).isEqualTo("6");
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5})
    void theAnswerDoesNotDependOnWhoMakesTheRunsAndInWhichOrder(long seed) throws Exception {
        Optional<RareEvent> one = split(new ThreadEngine(2, SplitRunsTest::answer));
        assertThat(split(new Careless(seed))).isEqualTo(one);
    }
}
