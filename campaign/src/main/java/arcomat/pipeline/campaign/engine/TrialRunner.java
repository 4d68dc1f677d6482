package arcomat.pipeline.campaign.engine;

import arcomat.campaign.Campaign;
import arcomat.campaign.CampaignParser;
import arcomat.campaign.Row;
import arcomat.campaign.Row.Ending;
import arcomat.campaign.Trial;
import arcomat.campaign.Watched;
import arcomat.campaign.coverage.ReachedItems;
import arcomat.pipeline.campaign.joint.JointRun;
import arcomat.pipeline.campaign.joint.JointWatching;
import arcomat.pipeline.campaign.measure.Measuring;
import arcomat.pipeline.world.Onlooker;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.sim.device.Limits;
import arcomat.sim.load.LoadedProgram;
import arcomat.sim.load.Probe;
import arcomat.sim.time.OutOfPatience;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.world.Summary;
import arcomat.world.World;
import arcomat.world.WorldParser;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
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

    /** One run of so many, the first one among them, is made in both ways. */
    private static final int CHECKED = 1000;

    private final Freight freight;
    private final SourceFile text;
    private final Map<String, LoadedProgram> programs = new TreeMap<>();

    /** The same ones, which never rest. */
    private final Map<String, LoadedProgram> onThreads = new TreeMap<>();

    private final Measuring measuring;
    private final JointWatching joint;
    private final List<Watched> watches;
    private final Optional<Campaign.Split> split;
    private final Map<Map<String, String>, Stage> stages = new ConcurrentHashMap<>();

    public TrialRunner(Freight freight) {
        this.freight = freight;
        this.text = new SourceFile("world", freight.world());
        Campaign campaign = campaign(freight);
        this.joint = JointWatching.of(freight.joint(), campaign, text);
        freight.programs()
                .forEach(
                        (key, each) ->
                                programs.put(
                                        key,
                                        LoadedProgram.forMany(
                                                each, probes(key), freight.coverage().lines(key))));
        programs.forEach((key, each) -> onThreads.put(key, each.onThreads()));
        this.measuring = Measuring.of(campaign, text);
        this.watches = campaign.watches();
        this.split = campaign.split();
    }

    private List<Probe> probes(String program) {
        List<Probe> probes = new ArrayList<>(Sightings.probes(freight.monitors()));
        probes.addAll(joint.probes(program));
        return probes;
    }

    private static Campaign campaign(Freight freight) {
        SourceFile campaign = new SourceFile("campaign", freight.campaign());
        return CampaignParser.parse(campaign).campaign().orElseThrow();
    }

    /**
     * A world with values.
     *
     * @param bare without programs
     * @param measuring what the campaign asks beside what every campaign does
     * @param joint what it watches several robots for
     * @param remark why there is no world; else empty
     */
    private record Stage(
            @Nullable World bare,
            @Nullable PreparedWorld world,
            Measuring.@Nullable InWorld measuring,
            JointWatching.@Nullable InWorld joint,
            String remark) {
        static Stage none(String remark) {
            return new Stage(null, null, null, null, remark);
        }
    }

    /**
     * Makes a run.
     *
     * @throws IllegalStateException where it turns out that programs do something else when their
     *     threads rest between slices: that would be a fault of ours
     */
    @Override
    public Row apply(Trial trial) {
        Stage stage = stage(trial.values());
        if (stage.bare() == null
                || stage.world() == null
                || stage.measuring() == null
                || stage.joint() == null) {
            return Row.withoutAnswers(trial, Ending.IMPOSSIBLE, stage.remark());
        }
        OneRun run = new OneRun(trial, stage.bare(), stage.measuring(), stage.joint());
        if (trial.number() % CHECKED != 0 || !anyRests()) {
            return run.row(stage.world(), Function.identity());
        }
        return run.checked(stage.world(), PreparedWorld.of(stage.bare(), onThreads));
    }

    private boolean anyRests() {
        return programs.values().stream().anyMatch(each -> each.rests(freight.limited()));
    }

    /** One run, which may be made again. */
    private final class OneRun {
        private final Trial trial;
        private final World bare;
        private final Measuring.InWorld measuring;
        private final JointWatching.InWorld joint;
        private boolean isOutOfPatience;

        OneRun(Trial trial, World bare, Measuring.InWorld measuring, JointWatching.InWorld joint) {
            this.trial = trial;
            this.bare = bare;
            this.measuring = measuring;
            this.joint = joint;
        }

        Row checked(PreparedWorld resting, PreparedWorld threads) {
            List<Fingerprint> prints = new ArrayList<>();
            Function<Onlooker, Onlooker> watched =
                    beside -> {
                        prints.add(new Fingerprint(beside));
                        return prints.get(prints.size() - 1);
                    };
            Row row = row(resting, watched);
            Row other = row(threads, watched);
            boolean same = row.equals(other) && prints.get(0).bits() == prints.get(1).bits();
            // Who is out of patience has seen a part of the run, and not always the same one.
            if (!same && !isOutOfPatience) {
                throw new IllegalStateException(
                        "seed %s with %s: the run is another one where threads do not rest"
                                .formatted(trial.seeds().text(), trial.values()));
            }
            return row;
        }

        Row row(PreparedWorld world, Function<Onlooker, Onlooker> watched) {
            Measuring.Run measured = measuring.start();
            LevelTimes levels = new LevelTimes(split, bare, measured);
            JointRun together = joint.start(levels);
            ItemNotes notes = new ItemNotes(freight.coverage(), bare, together);
            Sightings sightings = new Sightings(freight.monitors(), notes);
            try {
                Summary summary =
                        world.summarize(
                                trial.seeds(),
                                freight.patience(),
                                freight.limited() ? Limits.OF_THE_BRICK : Limits.NONE,
                                watched.apply(sightings));
                together.end();
                Optional<String> doubt = sightings.doubt().or(together::doubt);
                if (doubt.isPresent()) {
                    return Row.withoutAnswers(trial, Ending.GIVEN_UP, doubt.get());
                }
                ReachedItems reached = notes.reached();
                List<Double> answers = new ArrayList<>(Answers.of(summary, transitions(reached)));
                answers.addAll(measured.answers());
                answers.addAll(sightings.answers(watches));
                answers.addAll(together.answers());
                answers.addAll(levels.answers());
                return Row.made(trial, answers, reached);
            } catch (OutOfPatience e) {
                isOutOfPatience = true;
                String why = "after " + OutOfPatience.limit(freight.patience());
                return Row.withoutAnswers(trial, Ending.GIVEN_UP, why);
            }
        }
    }

    private double transitions(ReachedItems reached) {
        return reached.isKnown()
                ? reached.countBelow(freight.coverage().transitions())
                : Double.NaN;
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
            return Stage.none(why);
        }
        try {
            World world = parsed.world().get();
            PreparedWorld prepared = PreparedWorld.of(world, programs);
            return new Stage(world, prepared, measuring.in(world), joint.in(world), "");
        } catch (IllegalArgumentException e) {
            return Stage.none(String.valueOf(e.getMessage()));
        }
    }
}
