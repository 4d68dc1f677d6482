package arcomat.benchmarks.world;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;
import arcomat.pipeline.Progress;
import arcomat.pipeline.Session;
import arcomat.pipeline.WrongUse;
import arcomat.pipeline.world.PrepareWorld;
import arcomat.pipeline.world.PreparedWorld;
import arcomat.world.Recording;

import com.sun.management.OperatingSystemMXBean;

import java.lang.management.ManagementFactory;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/** Two robots meet on a line: how much faster than they would on the floor. */
public final class WorldGroup implements Group {
    private static final String WORLD = "models/coffee/world/meeting.world";
    private static final int WARMUP = 60;
    private static final int RUNS = 40;
    private static final int FASTER = 200;

    /** 5 ms for the 22 seconds of a meeting. */
    private static final int CAMPAIGN_FASTER = 4400;

    /**
     * Runs of a campaign before the PC's Java has compiled what they need: as many as it takes to
     * show that one of 1,000 fails. Then so many more are timed.
     */
    private static final int CAMPAIGN_WARMUP = 3000;

    private static final int CAMPAIGN_RUNS = 500;

    /** A run takes less than the clock of the processor's time tells apart. */
    private static final int TOGETHER = 25;

    private static final double NANOSECONDS = 1e6;

    private PreparedWorld world;

    @Override
    public String name() {
        return "world";
    }

    /** A run hands over between threads; it is timed as a whole. */
    @Override
    public List<String> prepare() {
        try {
            world = Session.in(Path.of(""), Progress.NONE).run(new PrepareWorld(WORLD, false));
        } catch (WrongUse e) {
            throw new IllegalStateException(e);
        }
        if (!world.run(1).succeeded()) {
            throw new IllegalStateException("the robots collide");
        }
        return List.of();
    }

    @Override
    public Map<String, Measurement> measure() {
        List<Double> times = new ArrayList<>();
        List<Double> real = new ArrayList<>();
        for (int seed = 0; seed < WARMUP + RUNS; seed++) {
            long start = System.nanoTime();
            Recording recording = world.run(seed);
            double time = (System.nanoTime() - start) / NANOSECONDS;
            if (seed >= WARMUP) {
                times.add(time);
                real.add((double) recording.duration());
            }
        }
        return Map.of(
                "meeting", Measurement.of("meeting", times, "ms/op"),
                "campaign", Measurement.of("campaign", campaign(), "ms/op"),
                "real time", Measurement.of("real time", real, "ms/op"));
    }

    /** The processor's time of a run that only says what it comes to, with all that Java does. */
    private List<Double> campaign() {
        List<Double> times = new ArrayList<>();
        for (int seed = 0; seed < CAMPAIGN_WARMUP + CAMPAIGN_RUNS; seed += TOGETHER) {
            long start = processorTime();
            for (int i = 0; i < TOGETHER; i++) {
                world.summarize(seed + i);
            }
            if (seed >= CAMPAIGN_WARMUP) {
                times.add((processorTime() - start) / NANOSECONDS / TOGETHER);
            }
        }
        return times;
    }

    private static long processorTime() {
        var system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        return system.getProcessCpuTime();
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise(
                                FASTER + " times the meeting of two fetchers, against real time",
                                "meeting",
                                "real time",
                                1)
                        .times(FASTER),
                Goal.promise(
                                CAMPAIGN_FASTER
                                        + " times the same in a campaign, in the processor's"
                                        + " time, against real time",
                                "campaign",
                                "real time",
                                1)
                        .times(CAMPAIGN_FASTER));
    }
}
