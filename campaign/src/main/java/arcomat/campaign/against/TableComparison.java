package arcomat.campaign.against;

import arcomat.campaign.CampaignResult;
import arcomat.campaign.CampaignResult.Occurrence;
import arcomat.campaign.CampaignResult.Spread;
import arcomat.campaign.Column;
import arcomat.campaign.EventPairs;
import arcomat.campaign.Quantity;
import arcomat.campaign.Row;
import arcomat.campaign.SeedPairs;
import arcomat.campaign.statistics.Confidence;
import arcomat.campaign.statistics.ConfidenceInterval;
import arcomat.campaign.statistics.Decision;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * Compares two tables, run by run where both have it. All that is said of events is wrong together
 * in at most 5 of 100 comparisons, and so is all that is said of measures: each has its share of
 * that error (Bonferroni).
 */
public final class TableComparison {
    private final FinishedTable before;
    private final FinishedTable now;
    private final CommonQuestions questions;
    private final List<OfEvent> events = new ArrayList<>();
    private final List<OfMeasure> measures = new ArrayList<>();
    private long pairs;

    private TableComparison(FinishedTable before, FinishedTable now) {
        this.before = before;
        this.now = now;
        this.questions = new CommonQuestions(before.campaign(), now.campaign());
        for (Column column : questions.columns()) {
            int first = before.campaign().column(column.name());
            int second = now.campaign().column(column.name());
            if (column.isEvent()) {
                events.add(new OfEvent(column, new EventPairs(column.name(), first, second)));
            } else {
                measures.add(new OfMeasure(column, first, second));
            }
        }
    }

    /** An event, and what pairs say of it. */
    private record OfEvent(Column column, EventPairs pairs) {}

    /** A measure, and which way it went in pairs. */
    private static final class OfMeasure {
        private final Column column;
        private final int first;
        private final int second;
        private final SeedPairs seeds = new SeedPairs();
        private long greater;
        private long smaller;

        OfMeasure(Column column, int first, int second) {
            this.column = column;
            this.first = first;
            this.second = second;
        }

        void see(Row one, Row other) {
            if (one.answers(first) && other.answers(second)) {
                int sign = Double.compare(other.answer(second), one.answer(first));
                greater += sign > 0 ? 1 : 0;
                smaller += sign < 0 ? 1 : 0;
                if (sign != 0) {
                    seeds.add(other.trial().seed(), Integer.signum(sign));
                }
            }
        }
    }

    /**
     * Reads both once.
     *
     * @param before the table that the other one is compared with
     */
    public static TableDifference of(FinishedTable before, FinishedTable now) {
        TableComparison comparison = new TableComparison(before, now);
        try (Stream<Row> older = before.rows().get();
                Stream<Row> newer = now.rows().get()) {
            comparison.see(new SeedGroups(older.iterator()), new SeedGroups(newer.iterator()));
        }
        return comparison.difference();
    }

    private void see(SeedGroups older, SeedGroups newer) {
        while (older.seed().isPresent() && newer.seed().isPresent()) {
            int order = Long.compare(older.seed().get(), newer.seed().get());
            if (order < 0) {
                older.take();
            } else if (order > 0) {
                newer.take();
            } else {
                seeSeed(older.take(), newer.take());
            }
        }
    }

    private void seeSeed(List<Row> older, List<Row> newer) {
        Map<Map<String, String>, Deque<Row>> open = new HashMap<>();
        for (Row row : older) {
            open.computeIfAbsent(questions.circumstances(row.trial()), c -> new ArrayDeque<>())
                    .add(row);
        }
        for (Row row : newer) {
            Deque<Row> mates = open.get(questions.circumstances(row.trial()));
            if (mates != null && !mates.isEmpty()) {
                see(mates.remove(), row);
            }
        }
    }

    private void see(Row one, Row other) {
        pairs++;
        events.forEach(each -> each.pairs().see(one, other));
        measures.forEach(each -> each.see(one, other));
    }

    /** What is chosen by how many runs there are, and not by what they say, is no second try. */
    private boolean isPaired() {
        return pairs > 0 && 2 * pairs >= Math.min(before.runs(), now.runs());
    }

    private boolean concludes() {
        return !before.endedEarly() && !now.endedEarly();
    }

    private TableDifference difference() {
        return new TableDifference(
                pairs,
                isPaired(),
                events.stream().map(this::difference).toList(),
                measures.stream()
                        .filter(each -> hasSpread(each, before.result()))
                        .filter(each -> hasSpread(each, now.result()))
                        .map(this::difference)
                        .toList(),
                questions.others());
    }

    private TableDifference.OfEvent difference(OfEvent event) {
        Occurrence older = occurrence(event.column(), before.result());
        Occurrence newer = occurrence(event.column(), now.result());
        return new TableDifference.OfEvent(
                older, newer, event.pairs().changes(), decision(event, older, newer));
    }

    private Decision decision(OfEvent event, Occurrence older, Occurrence newer) {
        double error = Confidence.USUAL.error() / events.size();
        if (!concludes()) {
            return Decision.UNDECIDED;
        }
        if (isPaired()) {
            return event.pairs().test().decision(error);
        }
        // Each interval may miss with half of the error: both are right with the rest.
        Confidence sure = new Confidence(1 - error / 2);
        ConfidenceInterval was = older.interval(sure);
        ConfidenceInterval is = newer.interval(sure);
        boolean wanted = event.column().name().equals(Quantity.GOAL.word());
        if (was.high() < is.low()) {
            return wanted ? Decision.HOLDS : Decision.FAILS;
        }
        if (is.high() < was.low()) {
            return wanted ? Decision.FAILS : Decision.HOLDS;
        }
        return Decision.UNDECIDED;
    }

    private static Occurrence occurrence(Column column, CampaignResult result) {
        return result.occurrences().stream()
                .filter(each -> each.column().equals(column))
                .findFirst()
                .orElseThrow();
    }

    /** There is none where no run has a number. */
    private static boolean hasSpread(OfMeasure measure, CampaignResult result) {
        return result.spreads().stream()
                .anyMatch(each -> each.column().equals(measure.column) && each.known() > 0);
    }

    private TableDifference.OfMeasure difference(OfMeasure measure) {
        double error = Confidence.USUAL.error() / measures.size();
        boolean differs = concludes() && isPaired() && measure.seeds.test().difference() <= error;
        return new TableDifference.OfMeasure(
                spread(measure.column, before.result()),
                spread(measure.column, now.result()),
                measure.greater,
                measure.smaller,
                differs);
    }

    private static Spread spread(Column column, CampaignResult result) {
        return result.spreads().stream()
                .filter(each -> each.column().equals(column))
                .findFirst()
                .orElseThrow();
    }
}
