package arcomat.benchmarks;

import arcomat.benchmarks.analysis.AnalysisGroup;
import arcomat.benchmarks.build.BuildGroup;
import arcomat.benchmarks.cold.ColdGroup;
import arcomat.benchmarks.compositions.CompositionsGroup;
import arcomat.benchmarks.compositions.DiskGroup;
import arcomat.benchmarks.data.DataGroup;
import arcomat.benchmarks.editor.EditorGroup;
import arcomat.benchmarks.frontend.FrontEndGroup;
import arcomat.benchmarks.guards.GuardsGroup;
import arcomat.benchmarks.incremental.IncrementalGroup;
import arcomat.benchmarks.measure.Baseline;
import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;
import arcomat.benchmarks.network.NetworkGroup;
import arcomat.benchmarks.step.StepGroup;
import arcomat.benchmarks.world.WorldGroup;

import org.openjdk.jmh.runner.Runner;
import org.openjdk.jmh.runner.RunnerException;
import org.openjdk.jmh.runner.options.ChainedOptionsBuilder;
import org.openjdk.jmh.runner.options.OptionsBuilder;
import org.openjdk.jmh.runner.options.VerboseMode;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * Runs groups of benchmarks, prints their ratios and keeps the figures as the new baseline: {@code
 * --forks N --groups step,network,frontend,guards,incremental,cold,analysis,build,world,
 * editor,compositions,disk,data}.
 */
public final class Main {
    private static final List<Group> GROUPS =
            List.of(
                    new StepGroup(),
                    new NetworkGroup(),
                    new FrontEndGroup(),
                    new GuardsGroup(),
                    new IncrementalGroup(),
                    new ColdGroup(),
                    new AnalysisGroup(),
                    new BuildGroup(),
                    new WorldGroup(),
                    new EditorGroup(),
                    new CompositionsGroup(),
                    new DiskGroup(),
                    new DataGroup());

    private Main() {}

    public static void main(String[] args) throws RunnerException, IOException {
        Locale.setDefault(Locale.ROOT);
        List<String> words = Arrays.asList(args);
        int forks = Integer.parseInt(words.get(words.indexOf("--forks") + 1));
        List<String> wanted = List.of(words.get(words.indexOf("--groups") + 1).split(","));
        for (Group group : GROUPS) {
            if (wanted.contains(group.name())) {
                run(group, forks);
            }
        }
    }

    private static void run(Group group, int forks) throws RunnerException, IOException {
        System.out.println("== " + group.name());
        List<String> notes = new ArrayList<>(group.prepare());
        notes.forEach(System.out::println);
        Map<String, Measurement> results =
                group.benchmarks().isEmpty() ? group.measure() : jmh(group, forks);
        results.values().forEach(Main::print);
        List<String> verdicts = verdicts(group, results);
        verdicts.forEach(System.out::println);
        notes.addAll(verdicts);
        Baseline.write(group, results, notes);
    }

    private static Map<String, Measurement> jmh(Group group, int forks) throws RunnerException {
        ChainedOptionsBuilder options =
                new OptionsBuilder().forks(forks).verbosity(VerboseMode.SILENT);
        group.benchmarks().forEach(type -> options.include(type.getName() + "\\."));
        return Measurement.of(new Runner(options.build()).run());
    }

    private static void print(Measurement result) {
        System.out.printf(
                "%-36s %12.3f %s   (quartiles %.3f to %.3f)%n",
                result.label(), result.median(), result.unit(), result.low(), result.high());
    }

    private static List<String> verdicts(Group group, Map<String, Measurement> results) {
        List<String> verdicts = new ArrayList<>();
        for (Goal goal : group.goals()) {
            double value = goal.value(results);
            String verdict = value <= goal.limit() ? "met" : "MISSED";
            verdicts.add(
                    String.format(
                            "%s: %.2f, %s at most %.2f: %s",
                            goal.text(),
                            value,
                            goal.promised() ? "promised" : "aim",
                            goal.limit(),
                            verdict));
        }
        return verdicts;
    }
}
