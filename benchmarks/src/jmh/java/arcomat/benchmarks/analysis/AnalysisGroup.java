package arcomat.benchmarks.analysis;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/** Formal analyses: warm, cold, large, and beside MONA where that is installed. */
public final class AnalysisGroup implements Group {
    private final boolean mona = isInstalled();

    @Override
    public String name() {
        return "analysis";
    }

    @Override
    public List<Class<?>> benchmarks() {
        return mona
                ? List.of(AnalysisBenchmark.class, ProcessBenchmark.class)
                : List.of(AnalysisBenchmark.class);
    }

    @Override
    public List<String> prepare() {
        List<String> notes = new ArrayList<>(Large.measure());
        if (!mona) {
            notes.add("MONA is not installed: nothing is compared with it");
        }
        return notes;
    }

    private static boolean isInstalled() {
        try {
            return new ProcessBuilder("mona", "-h")
                            .redirectErrorStream(true)
                            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                            .start()
                            .waitFor()
                    >= 0;
        } catch (IOException | InterruptedException absent) {
            return false;
        }
    }

    @Override
    public List<Goal> goals() {
        return mona
                ? List.of(
                        Goal.promise("figure, warm, against MONA", "figure", "figureMona", 0.02),
                        Goal.aim("figure, cold, against MONA", "figureCold", "figureMona", 1),
                        Goal.promise(
                                "20 states, warm, against MONA", "random20", "random20Mona", 0.001),
                        Goal.promise(
                                "20 states, cold, against MONA",
                                "random20Cold",
                                "random20Mona",
                                0.01))
                : List.of();
    }
}
