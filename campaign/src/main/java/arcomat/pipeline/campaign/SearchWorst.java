package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Demand.Side;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Variation;
import arcomat.campaign.WorstSearch;
import arcomat.campaign.statistics.WorstCase;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/**
 * Looks for the run with the smallest or largest number, where a campaign asks for it: a generation
 * of runs after the other, each where the ones before were the worst. Runs of a generation have the
 * same seed, so that they differ in their values alone; the next generation has the next seed. The
 * campaign alone decides which runs are made.
 *
 * @param engines starts who makes the runs
 */
public record SearchWorst(PrepareCampaign.Ready ready, Function<Freight, Engine> engines)
        implements Task<Optional<WorstSearch>> {
    /**
     * Empty where the campaign does not ask for it.
     *
     * @throws WrongUse where runs cannot go on
     */
    @Override
    public Optional<WorstSearch> run(Session session) throws WrongUse {
        if (ready.campaign().search().isEmpty()) {
            return Optional.empty();
        }
        Campaign.Search search = ready.campaign().search().get();
        try (Engine engine = engines.apply(ready.freight())) {
            return Optional.of(new Course(ready.campaign(), search, engine).run(session));
        } catch (EngineFailure e) {
            throw new WrongUse("%s", String.valueOf(e.getMessage()));
        }
    }

    /** One search, with what it has found so far. */
    private static final class Course {
        private final Campaign campaign;
        private final Campaign.Search search;
        private final Engine engine;
        private final int column;
        private Optional<Row> worst = Optional.empty();
        private List<WorstSearch.Step> steps = List.of();
        private int runs;

        Course(Campaign campaign, Campaign.Search search, Engine engine) {
            this.campaign = campaign;
            this.search = search;
            this.engine = engine;
            this.column = campaign.column(search.measure());
        }

        WorstSearch run(Session session) {
            WorstCase course = WorstCase.start(campaign.variations().size(), campaign.firstSeed());
            for (long generation = 0; runs < search.runs(); generation++) {
                List<Row> rows = rows(course.points(), generation, session);
                rows.forEach(this::compare);
                steps = WorstSearch.with(steps, step(rows), search.side());
                course = course.next(rows.stream().mapToDouble(this::badness).toArray());
            }
            return new WorstSearch(
                    search,
                    steps,
                    worst.map(row -> new WorstSearch.Found(row, row.answer(column))),
                    course.searches());
        }

        private WorstSearch.Step step(List<Row> rows) {
            List<Row> known = rows.stream().filter(row -> row.answers(column)).toList();
            Optional<Double> worstOfAll =
                    known.stream()
                            .min(Comparator.comparingDouble(this::badness))
                            .map(row -> row.answer(column));
            return new WorstSearch.Step(1, rows.size(), rows.size() - known.size(), worstOfAll);
        }

        private List<Row> rows(List<double[]> points, long generation, Session session) {
            List<Trial> trials = new ArrayList<>();
            for (double[] point : points) {
                trials.add(new Trial(runs++, campaign.firstSeed() + generation, values(point)));
            }
            String work = "generation %,d of the search".formatted(generation + 1);
            return new RowsInOrder(engine, session, work).of(trials);
        }

        private Map<String, String> values(double[] point) {
            Map<String, String> values = new LinkedHashMap<>();
            for (int i = 0; i < point.length; i++) {
                Variation each = campaign.variations().get(i);
                values.put(each.parameter(), each.domain().at(point[i]));
            }
            return values;
        }

        private void compare(Row row) {
            double bad = badness(row);
            if (!Double.isNaN(bad) && worst.map(this::badness).filter(w -> w <= bad).isEmpty()) {
                worst = Optional.of(row);
            }
        }

        /** The smaller the worse; not a number where a run has none. */
        private double badness(Row row) {
            if (!row.answers(column)) {
                return Double.NaN;
            }
            return search.side() == Side.BELOW ? row.answer(column) : -row.answer(column);
        }
    }
}
