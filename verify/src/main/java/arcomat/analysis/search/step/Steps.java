package arcomat.analysis.search.step;

import arcomat.analysis.search.IntKey;
import arcomat.model.Trace;
import arcomat.semantics.expression.Output;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
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

    /** The steps of several configurations together. What is used is noted with theirs, too. */
    public static Steps union(List<Steps> parts) {
        int size = parts.stream().mapToInt(Steps::size).sum();
        int[] outputs = new int[size];
        int[] next = new int[size];
        List<List<Trace.Cause>> causes = new ArrayList<>(size);
        List<Output> whole = new ArrayList<>(size);
        int position = 0;
        for (Steps part : parts) {
            System.arraycopy(part.outputs, 0, outputs, position, part.size());
            System.arraycopy(part.next, 0, next, position, part.size());
            causes.addAll(part.causes);
            whole.addAll(part.whole);
            position += part.size();
        }
        return new Steps(outputs, next, causes, whole, new boolean[size], parts);
    }

    /** The same for the same reasons, but what is sent is something else, and leads elsewhere. */
    public Steps changed(int[] otherOutputs, int[] otherNext) {
        return new Steps(
                otherOutputs, otherNext, causes, whole, new boolean[size()], List.of(this));
    }

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

    /** Collects steps, each once. */
    public static final class Collector {
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
            boolean[] used = new boolean[causes.size()];
            return new Steps(outputs.toArray(), next.toArray(), causes, whole, used, List.of());
        }
    }
}
