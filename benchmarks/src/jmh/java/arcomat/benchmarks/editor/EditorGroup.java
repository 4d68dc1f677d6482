package arcomat.benchmarks.editor;

import arcomat.benchmarks.measure.Goal;
import arcomat.benchmarks.measure.Group;
import arcomat.benchmarks.measure.Measurement;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/** What somebody waits for at an editor, with a thousand components in the workspace. */
public final class EditorGroup implements Group {
    @Override
    public String name() {
        return "editor";
    }

    @Override
    public Map<String, Measurement> measure() throws IOException {
        return Latencies.measure();
    }

    @Override
    public List<Goal> goals() {
        return List.of(
                Goal.promise(
                        "findings after a key, against a check of all",
                        Latencies.KEY,
                        Latencies.FULL,
                        0.3),
                Goal.limit("findings after a key, ms", Latencies.KEY, 100),
                Goal.limit("the same in a part of 100, ms", Latencies.KEY_OF_SHARED, 100),
                Goal.limit("completion, ms", Latencies.COMPLETION, 50),
                Goal.limit("hover, ms", Latencies.HOVER, 20),
                Goal.limit("a port renamed in 100 files, ms", Latencies.RENAME, 1000),
                Goal.limit("from the start to the first findings, ms", Latencies.START, 2000),
                Goal.limit("memory, MB", Latencies.MEMORY, 1024));
    }
}
