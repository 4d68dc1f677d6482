package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.time.OutOfPatience;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Summary;
import arcomat.world.WorldParser;

import org.jspecify.annotations.Nullable;

import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Function;

/**
 * Makes runs of what it was given, in this process; any number of threads may ask at once. What
 * runs share is prepared once.
 */
public final class TrialRunner implements Function<Trial, Row> {
    /** Worlds with their values: on a grid they come again, drawn ones do not. */
    private static final int KEPT = 1000;

    private final Freight freight;
    private final SourceFile text;
    private final Map<String, LoadedProgram> programs = new TreeMap<>();
    private final Map<Map<String, String>, Stage> stages = new ConcurrentHashMap<>();

    public TrialRunner(Freight freight) {
        this.freight = freight;
        this.text = new SourceFile("world", freight.world());
        freight.programs().forEach((key, each) -> programs.put(key, LoadedProgram.forMany(each)));
    }

    /**
     * A world with values.
     *
     * @param remark why there is none; else empty
     */
    private record Stage(@Nullable PreparedWorld world, String remark) {}

    @Override
    public Row apply(Trial trial) {
        Stage stage = stage(trial.values());
        if (stage.world() == null) {
            return Row.withoutAnswers(trial, Ending.IMPOSSIBLE, stage.remark());
        }
        try {
            Summary summary =
                    stage.world()
                            .summarize(
                                    trial.seed(),
                                    Duration.ofSeconds(freight.patienceSeconds()),
                                    freight.limited() ? Limits.OF_THE_BRICK : Limits.NONE);
            return Row.made(trial, Answers.of(summary));
        } catch (OutOfPatience e) {
            String why = "after " + freight.patienceSeconds() + " s of the PC's time";
            return Row.withoutAnswers(trial, Ending.GIVEN_UP, why);
        }
    }

    private Stage stage(Map<String, String> values) {
        if (stages.size() > KEPT) {
            stages.clear();
        }
        return stages.computeIfAbsent(values, this::prepare);
    }

    private Stage prepare(Map<String, String> values) {
        WorldParser.Parsed parsed = WorldParser.parse(text, values);
        if (parsed.world().isEmpty()) {
            Diagnostic first = parsed.findings().get(0);
            String why = "line " + first.span().startPosition().line() + ": " + first.message();
            return new Stage(null, why);
        }
        try {
            PreparedWorld world = PreparedWorld.of(parsed.world().get(), programs);
            return new Stage(world, "");
        } catch (IllegalArgumentException e) {
            return new Stage(null, String.valueOf(e.getMessage()));
        }
    }
}
