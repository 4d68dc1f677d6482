package arcomat.benchmarks.compositions;

import arcomat.benchmarks.measure.ClassArchive;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Compositions of growing size, each in a process of its own, beside Spin's compiled verifier for
 * the same system where Spin is installed. User time, since a process that waits is not to blame
 * for it; that of ours includes all of Java's start and its compiler. It starts as the installed
 * tool does, with an archive of its classes.
 */
public final class CompositionsGroup implements Group {
    /** {@code -Dsystems="shift 16,shift 20"} asks about others. */
    private static final String USUAL =
            "philosophers 6,philosophers 7,philosophers 8,philosophers 9,tokens 7,tokens 8,tokens"
                    + " 9,shift 14,shift 18,shift 20,shift 22,queues 4,queues 6,queues 8,queues"
                    + " 9,leader 8,leader 10";

    /** Those that both engines are asked about, besides the large ones; Spin is not. */
    private static final List<String> SYMBOLIC =
            List.of(
                    "philosophers 9",
                    "philosophers 10",
                    "philosophers 12",
                    "tokens 12",
                    "tokens 40");

    private static final String SMALL = "philosophers 6";
    private static final String TOGETHER = " with both engines";
    private static final String LARGEST = "philosophers 12";
    private static final double SECONDS = 10;

    private static final double HALF = 0.5;

    /** From so many configurations on something is aimed at: below, Java's start is most of it. */
    private static final long LARGE = 1_000_000;

    private static final String MEMORY = " memory";
    private static final String CLOCK = " by the clock";
    private static final String SPIN = " Spin";

    private final List<ComposedSystem> systems = new ArrayList<>();
    private final List<String> large = new ArrayList<>();
    private final boolean spin = SpinVerifier.isInstalled();

    public CompositionsGroup() {
        for (String each : System.getProperty("systems", USUAL).split(",")) {
            systems.add(system(each));
        }
    }

    private static ComposedSystem system(String label) {
        String[] words = label.strip().split(" ");
        return ComposedSystems.of(words[0], Integer.parseInt(words[1]));
    }

    @Override
    public String name() {
        return "compositions";
    }

    @Override
    public List<String> prepare() {
        return spin ? List.of() : List.of("spin or gcc is not installed: nothing is compared");
    }

    @Override
    public Map<String, Measurement> measure() throws IOException {
        Map<String, Measurement> results = new LinkedHashMap<>();
        try {
            ClassArchive classes = ClassArchive.leftBy(command(system(SMALL), List.of()));
            for (ComposedSystem system : systems) {
                measure(system, classes, results);
            }
            for (String label : SYMBOLIC) {
                measureTogether(system(label), classes, results);
            }
        } catch (InterruptedException e) {
            throw new IOException(e);
        }
        return results;
    }

    private void measure(
            ComposedSystem system, ClassArchive classes, Map<String, Measurement> results)
            throws IOException, InterruptedException {
        UserTime ours =
                UserTime.of(classes.used(command(system, List.of(AskedComposition.EXPLICIT))));
        long configurations = AskedComposition.configurations(system, ours);
        if (configurations >= LARGE) {
            large.add(system.label());
            measureTogether(system, classes, results);
        }
        add(results, system.label(), ours);
        Measurement.put(results, system.label() + " configurations", configurations, "");
        Measurement.put(
                results, system.label() + " a second", configurations / ours.seconds(), "/s");
        if (spin) {
            UserTime theirs = SpinVerifier.run(system);
            add(results, system.label() + SPIN, theirs);
            Measurement.put(
                    results, system.label() + SPIN + " states", SpinVerifier.stored(theirs), "");
        }
    }

    /** As somebody asks who chooses no options: the first engine to answer counts. */
    private static void measureTogether(
            ComposedSystem system, ClassArchive classes, Map<String, Measurement> results)
            throws IOException, InterruptedException {
        UserTime time = UserTime.of(classes.used(command(system, List.of())));
        AskedComposition.configurations(system, time);
        add(results, system.label() + TOGETHER, time);
    }

    private static void add(Map<String, Measurement> results, String label, UserTime time) {
        Measurement.put(results, label, time.seconds(), "s");
        Measurement.put(results, label + CLOCK, time.elapsed(), "s");
        Measurement.put(results, label + MEMORY, time.megabytes(), "MB");
    }

    private static List<String> command(ComposedSystem system, List<String> more) {
        return AskedComposition.command("6g", system, more);
    }

    @Override
    public List<Goal> goals() {
        List<Goal> goals = new ArrayList<>();
        goals.add(Goal.aim(LARGEST + ", seconds", LARGEST + TOGETHER, "", SECONDS));
        for (String label : spin ? large : List.<String>of()) {
            for (String engines : List.of("", TOGETHER)) {
                goals.add(half(label + engines, "time", "", label));
                goals.add(half(label + engines, "time" + CLOCK, CLOCK, label));
                goals.add(half(label + engines, "memory", MEMORY, label));
            }
        }
        return goals;
    }

    /** Half of what Spin takes of something. */
    private static Goal half(String asked, String what, String measured, String label) {
        String name = "%s, %s of Spin's".formatted(asked, what);
        return Goal.aim(name, asked + measured, label + SPIN + measured, HALF);
    }
}
