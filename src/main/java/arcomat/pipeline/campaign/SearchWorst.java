package arcomat.pipeline.campaign;

import arcomat.campaign.Campaign;
import arcomat.campaign.Demand.Side;
import arcomat.campaign.Row;
import arcomat.campaign.Trial;
import arcomat.campaign.Variation;
import arcomat.campaign.WorstRun;
import arcomat.campaign.statistics.WorstCase;
import arcomat.pipeline.Session;
import arcomat.pipeline.Task;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.campaign.engine.Engine;
import arcomat.pipeline.campaign.engine.EngineFailure;
import arcomat.pipeline.campaign.engine.Freight;

import java.util.ArrayList;
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
        implements Task<Optional<WorstRun>> {
    /**
     * Empty where the campaign does not ask for it, or no run has such a number.
     *
     * @throws WrongUse where runs cannot go on
     */
    @Override
    public Optional<WorstRun> run(Session session) throws WrongUse {
        if (ready.campaign().search().isEmpty()) {
            return Optional.empty();
        }
        Campaign.Search search = ready.campaign().search().get();
        try (Engine engine = engines.apply(ready.freight())) {
            return new Course(ready.campaign(), search, engine).run(session);
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
        private int runs;

        Course(Campaign campaign, Campaign.Search search, Engine engine) {
            this.campaign = campaign;
            this.search = search;
            this.engine = engine;
            this.column = campaign.column(search.measure());
        }

        Optional<WorstRun> run(Session session) {
            WorstCase course = WorstCase.start(campaign.variations().size(), campaign.firstSeed());
            for (long generation = 0; runs < search.runs(); generation++) {
                List<Row> rows = rows(course.points(), generation, session);
                rows.forEach(this::compare);
                course = course.next(rows.stream().mapToDouble(this::badness).toArray());
            }
            int searches = course.searches();
            return worst.map(row -> new WorstRun(search, row, row.answer(column), runs, searches));
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
            if (!row.wasMade()) {
                return Double.NaN;
            }
            return search.side() == Side.BELOW ? row.answer(column) : -row.answer(column);
        }
    }
}
