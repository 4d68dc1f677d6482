package arcomat.analysis.search.step;

import arcomat.model.Trace;
import arcomat.semantics.expression.Output;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.List;

/** Gathers steps, and leaves out those that are there already. */
public final class StepCollector {
    private final IntArrayList outputs = new IntArrayList(2);
    private final IntArrayList next = new IntArrayList(2);
    private final List<List<Trace.Cause>> causes = new ArrayList<>(2);
    private final List<Output> whole = new ArrayList<>(2);

    public void add(int output, int configuration, List<Trace.Cause> cause, Output all) {
        for (int i = 0; i < causes.size(); i++) {
            if (outputs.get(i) == output
                    && next.get(i) == configuration
                    && causes.get(i).equals(cause)) {
                return;
            }
        }
        outputs.add(output);
        next.add(configuration);
        causes.add(cause);
        whole.add(all);
    }

    public Steps steps() {
        return new Steps(
                outputs.toArray(),
                next.toArray(),
                causes,
                whole,
                new boolean[causes.size()],
                List.of());
    }
}
