package arcomat.report.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.CampaignResult;
import arcomat.campaign.Judge;
import arcomat.campaign.RareEvent;
import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.Trials;
import arcomat.campaign.WorstSearch;
import arcomat.campaign.against.FinishedTable;
import arcomat.campaign.against.TableComparison;
import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.Coverage;
import arcomat.campaign.coverage.CoverageCount;
import arcomat.campaign.coverage.CoverageItems;
import arcomat.campaign.coverage.ItemNumbers;
import arcomat.campaign.coverage.PartItems;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.campaign.overview.Overview;
import arcomat.campaign.statistics.Families;
import arcomat.campaign.statistics.Measurements;
import arcomat.campaign.statistics.Splitting;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import java.util.stream.Stream;

/** Campaigns with rows that nobody has run: the faster and the darker, the worse. */
final class SampleCampaigns {
    static final String COMPARED =
            """
            world ../world/yard.world
            vary speed from 100 to 300
            vary light from 0 to 4
            vary driver of yard.Driver yard.CarefulDriver
            sample random 2000
            require collision below 0.2 at 95
            require failure below 0.001 at 95
            require 95 of reached below 20 at 95
            compare driver by collision
            """;

    static final String SEARCHED =
            """
            world ../world/yard.world
            vary speed from 100 to 250
            vary light from 0 to 4
            sample random 500
            worst smallest distance runs 300
            split on distance levels 200 100 50 20 runs 400
            """;

    private static final AutomatonItems DRIVER =
            new AutomatonItems(
                    "yard.Driver",
                    "models/yard/yard/Driver.arc",
                    List.of(
                            new AutomatonItems.Transition(12, "standing -> driving", 1, true),
                            new AutomatonItems.Transition(
                                    13, "driving -> standing [near]", 0, true),
                            new AutomatonItems.Transition(14, "driving -> hurt [<hit>]", 2, true),
                            new AutomatonItems.Transition(15, "driving -> lost [lost]", 3, true),
                            new AutomatonItems.Transition(16, "driving -> lost [off]", 3, false)),
                    List.of(
                            new AutomatonItems.State(8, "standing"),
                            new AutomatonItems.State(8, "driving"),
                            new AutomatonItems.State(9, "hurt"),
                            new AutomatonItems.State(9, "lost")),
                    List.of(0));

    private static final AutomatonItems BELL =
            new AutomatonItems(
                    "yard.Bell",
                    "models/yard/yard/Bell.arc",
                    List.of(new AutomatonItems.Transition(6, "silent -> silent", 0, true)),
                    List.of(new AutomatonItems.State(4, "silent")),
                    List.of(0));

    private static final CoverageItems ITEMS =
            new CoverageItems(
                    List.of(BELL, DRIVER),
                    List.of(
                            new PartItems("truck", "driver", 1),
                            new PartItems("truck", "horn.bell", 0),
                            new PartItems("van", "", 1)),
                    List.of("truck.jar"));

    private SampleCampaigns() {}

    static Coverage coverage(Campaign campaign) {
        CoverageCount count = new CoverageCount(ITEMS);
        rows(campaign).map(Row::reached).forEach(count::see);
        return count.coverage();
    }

    static Campaign campaign(String text) {
        return CampaignParser.parse(new SourceFile("sample.campaign", text))
                .campaign()
                .orElseThrow();
    }

    static CampaignReport report(String file, String text) {
        return report(file, text, Optional.empty(), Optional.empty());
    }

    /** Level by level fewer; the search settles once. */
    static CampaignReport searched(String file) {
        Campaign campaign = campaign(SEARCHED);
        Row row = rows(campaign).filter(Row::wasMade).findFirst().orElseThrow();
        List<WorstSearch.Step> course = new ArrayList<>();
        double least = 150;
        for (int i = 0; i < 40; i++) {
            least = i == 20 ? 120 : least * 0.93;
            Optional<Double> worst = i == 3 ? Optional.empty() : Optional.of(least + i * 7 % 11);
            course.add(new WorstSearch.Step(1, 8, i == 3 ? 8 : 0, worst));
        }
        WorstSearch search =
                new WorstSearch(
                        campaign.search().orElseThrow(),
                        course,
                        Optional.of(new WorstSearch.Found(row, 31.4)),
                        2);
        List<Splitting.Level> levels =
                List.of(
                        new Splitting.Level(400, 180),
                        new Splitting.Level(400, 95),
                        new Splitting.Level(400, 60),
                        new Splitting.Level(400, 36));
        List<Long> families = new ArrayList<>(Collections.nCopies(36, 1L));
        RareEvent rare =
                new RareEvent(
                        campaign.split().orElseThrow(),
                        levels,
                        new Families(families),
                        1600,
                        0,
                        Optional.of(new RareEvent.Nearest(row, 12.5)));
        return report(file, SEARCHED, Optional.of(search), Optional.of(rare));
    }

    private static CampaignReport report(
            String file, String text, Optional<WorstSearch> worst, Optional<RareEvent> rare) {
        Campaign campaign = campaign(text);
        Judge judge = new Judge(campaign);
        rows(campaign).forEach(judge::see);
        return new CampaignReport(
                file,
                campaign,
                new RunAgain("models/yard/world/yard.world", true, List.of(), List.of()),
                judge.result(column -> measured(campaign, column)),
                Overview.of(campaign, () -> rows(campaign)),
                coverage(campaign),
                worst,
                rare,
                Trials.of(campaign).count(),
                "0123456789abcdef",
                List.of());
    }

    /** A hasty driver beside a careful one on the same seeds, and beside itself on others. */
    static CampaignReport against(String file) {
        String text =
                "world w\nvary driver of yard.Hasty\nvary light from 0 to 4\nsample random 500\n";
        FinishedTable now = table("build/new", text);
        return report(file, text)
                .against(
                        Stream.of(
                                        table("build/careful", text.replace("Hasty", "Careful")),
                                        table("build/others", text + "seeds from 1001\n"))
                                .map(
                                        old ->
                                                new TablesReport(
                                                        old, now, TableComparison.of(old, now)))
                                .toList());
    }

    private static FinishedTable table(String name, String text) {
        Campaign campaign = campaign(text);
        Judge judge = new Judge(campaign);
        rows(campaign).forEach(judge::see);
        CampaignResult result = judge.result(column -> measured(campaign, column));
        return new FinishedTable(name, campaign, result, "fedcba9876543210", () -> rows(campaign));
    }

    private static Measurements measured(Campaign campaign, String column) {
        int place = campaign.column(column);
        return Measurements.of(
                () ->
                        rows(campaign)
                                .filter(Row::wasMade)
                                .mapToDouble(row -> row.answer(place))
                                .filter(number -> !Double.isNaN(number)));
    }

    static Stream<Row> rows(Campaign campaign) {
        Trials trials = Trials.of(campaign);
        return LongStream.range(0, trials.count())
                .mapToObj(trials::trial)
                .map(trial -> row(trial, campaign.columns().size()));
    }

    /** The same for the same seed, but for what the driver makes of it. */
    private static Row row(Trial trial, int columns) {
        SplittableRandom chance = new SplittableRandom(trial.seed());
        double speed = number(trial, "speed", 200);
        double light = number(trial, "light", 1);
        if (speed > 299.5) {
            return Row.withoutAnswers(trial, Ending.IMPOSSIBLE, "line 7: too fast");
        }
        boolean careful = trial.values().getOrDefault("driver", "").contains("Careful");
        double risk = (speed - 100) / 200 * light / 4;
        double luck = chance.nextDouble();
        boolean collides = luck < (careful ? risk * risk : risk);
        boolean arrives = !collides || chance.nextDouble() < 0.3;
        double time = 2200 / speed + 4 * chance.nextDouble();
        List<Double> answers = new ArrayList<>();
        for (String column :
                List.of(
                        "collision",
                        "deadlock",
                        "failure",
                        "goal",
                        "time",
                        "reached",
                        "delivered",
                        "distance",
                        "clearance",
                        "late",
                        "transitions")) {
            answers.add(
                    switch (column) {
                        case "collision" -> collides ? 1.0 : 0.0;
                        case "goal" -> arrives ? 1.0 : 0.0;
                        case "deadlock" -> !collides && luck > 0.995 ? 1.0 : 0.0;
                        case "time" -> arrives ? time : 30;
                        case "reached" -> arrives ? time : Double.POSITIVE_INFINITY;
                        case "delivered" -> (double) (int) (4 * chance.nextDouble());
                        case "distance" -> collides ? 0 : 300 * luck * (1 - risk);
                        case "clearance" -> Double.NaN;
                        case "transitions" -> collides ? 4.0 : 3.0;
                        default -> 0.0;
                    });
        }
        while (answers.size() < columns) {
            answers.add(Double.POSITIVE_INFINITY); // levels that were not reached
        }
        BitSet reached = new BitSet();
        reached.set(0, collides ? 4 : 3);
        ItemNumbers truck = ITEMS.ofParts().get(0);
        ItemNumbers van = ITEMS.ofParts().get(2);
        reached.set(truck.transition(), truck.transition() + (collides ? 3 : 2));
        reached.set(van.transition(), van.transition() + 2);
        for (ItemNumbers each : List.of(ITEMS.ofAutomaton(0), ITEMS.ofAutomaton(1), truck, van)) {
            reached.set(each.initial());
        }
        return Row.made(trial, answers, ReachedItems.of(reached));
    }

    private static double number(Trial trial, String name, double otherwise) {
        String value = trial.values().get(name);
        return value == null ? otherwise : Double.parseDouble(value);
    }
}
