package arcomat.analysis.search.step;

import arcomat.model.Trace;
import arcomat.semantics.expression.Output;

import java.util.ArrayList;
import java.util.List;

/**
 * The steps of several configurations together. What is used is noted with the steps themselves.
 */
public final class StepUnion {
    private final List<Steps> parts = new ArrayList<>();
    private int size;

    public void add(Steps steps) {
        parts.add(steps);
        size += steps.size();
    }

    public Steps steps() {
        int[] outputs = new int[size];
        int[] next = new int[size];
        List<List<Trace.Cause>> causes = new ArrayList<>(size);
        List<Output> whole = new ArrayList<>(size);
        int position = 0;
        for (Steps part : parts) {
            System.arraycopy(part.outputs(), 0, outputs, position, part.size());
            System.arraycopy(part.next(), 0, next, position, part.size());
            causes.addAll(part.causes());
            whole.addAll(part.whole());
            position += part.size();
        }
        return new Steps(outputs, next, causes, whole, new boolean[size], parts);
    }
}
