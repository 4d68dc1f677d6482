package arcomat.analysis.search.step;

import arcomat.analysis.search.IntKey;
import arcomat.model.Trace;
import arcomat.semantics.expression.Output;

import java.util.Arrays;
import java.util.List;
import java.util.Set;

/**
 * All steps out of a configuration with one kind of letter, each once.
 *
 * @param outputs numbers of output cubes, in text order of the causes
 * @param next numbers of configurations
 * @param causes per step, of each automaton involved
 * @param whole per step what is sent on all ports, also on those that are not compared
 * @param used whether a search has needed the step; written by searches
 * @param parts for the steps of several configurations: those of each; else empty
 */
public record Steps(
        int[] outputs,
        int[] next,
        List<List<Trace.Cause>> causes,
        List<Output> whole,
        boolean[] used,
        List<Steps> parts) {

    public int size() {
        return outputs.length;
    }

    /** Whether both do the same for the same reasons. */
    boolean isSame(Steps other) {
        return Arrays.equals(outputs, other.outputs)
                && Arrays.equals(next, other.next)
                && causes.equals(other.causes)
                && whole.equals(other.whole);
    }

    /** Equal for steps that are the same. */
    List<Object> content() {
        return List.of(new IntKey(outputs), new IntKey(next), causes, whole);
    }

    /** Notes that a search needs a step. */
    public void use(int step) {
        used[step] = true;
        int position = step;
        for (Steps part : parts) {
            if (position < part.size()) {
                part.use(position);
                return;
            }
            position -= part.size();
        }
    }

    /** Adds what made the steps that a search has needed. */
    void collectUsed(Set<Trace.Cause> found) {
        for (int step = 0; step < used.length; step++) {
            if (used[step]) {
                found.addAll(causes.get(step));
            }
        }
    }
}
