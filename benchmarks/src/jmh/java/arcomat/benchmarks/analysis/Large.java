package arcomat.benchmarks.analysis;

import arcomat.analysis.refinement.Refinement;
import arcomat.analysis.refinement.Verdict;
import arcomat.analysis.search.Budget;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Comparisons of many states, each in a process of its own with a limit on its memory. */
public final class Large {
    private static final long MOST_STATES = 100_000_000;

    private Large() {}

    /** What was seen, a line for each comparison; the second time in each process counts. */
    static List<String> measure() {
        List<String> lines = new ArrayList<>();
        for (int[] lengths :
                new int[][] {{31, 32}, {99, 101}, {316, 317}, {997, 1009}, {3162, 3163}}) {
            lines.add(run("2g", "counters", lengths));
        }
        lines.add(run("2g", "counters", 2719, 2729) + "; promised under 5 s in 2 GB");
        lines.add(run("1g", "wide", 10_000) + "; promised under 10 s in 1 GB");
        return lines;
    }

    private static String run(String memory, String kind, int... sizes) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(List.of("-Xmx" + memory, "-Xss64m", "-XX:+UseSerialGC"));
        command.addAll(List.of("-cp", System.getProperty("java.class.path")));
        command.add(Large.class.getName());
        command.add(kind);
        for (int size : sizes) {
            command.add(String.valueOf(size));
        }
        try {
            Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
            String line = new String(process.getInputStream().readAllBytes()).strip();
            return process.waitFor() == 0 ? line + ", heap " + memory : kind + " broke: " + line;
        } catch (IOException | InterruptedException e) {
            return kind + " could not be run: " + e;
        }
    }

    /** {@code counters 31 32} or {@code wide 10000}. */
    public static void main(String[] arguments) {
        int first = Integer.parseInt(arguments[1]);
        Models models =
                Models.of(
                        arguments[0].equals("counters")
                                ? Cases.counters(first, Integer.parseInt(arguments[2]))
                                : Cases.wide(first));
        check(models);
        long start = System.nanoTime();
        Verdict verdict = check(models);
        System.out.printf(
                Locale.ROOT,
                "%s, %,d pairs: %s after %.3f s%n",
                arguments[0],
                verdict.explored().pairs(),
                verdict.answer(),
                (System.nanoTime() - start) / 1e9);
    }

    private static Verdict check(Models models) {
        return Refinement.check(
                models.promise("load.A"),
                models.promise("load.B"),
                new Budget(() -> false, MOST_STATES));
    }
}
