package arcomat.analysis;

import arcomat.model.Value;
import arcomat.semantics.Promise;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Whether one side simulates the other, from its definition: of all pairs within reach, those are
 * crossed out that have a step without an answer, until nothing changes any more.
 */
public final class NaiveSimulation {
    private record Pair(Object left, Object right) {}

    private final NaiveMachine left;
    private final NaiveMachine right;
    private final List<Map<String, Value>> inputs;
    private final List<Map<String, Value>> outputs;
    private final Set<Pair> related = new HashSet<>();

    public NaiveSimulation(Promise left, Promise right) {
        NaiveInclusion letters = new NaiveInclusion(left, right);
        this.left = letters.left;
        this.right = letters.right;
        this.inputs = letters.inputs;
        this.outputs = letters.outputs;
    }

    public boolean holds() {
        outputs.forEach(output -> reach(left.starts(output), right.starts(output)));
        while (related.removeIf(pair -> !isAnswered(pair))) {
            continue;
        }
        return outputs.stream()
                .allMatch(output -> isAnswered(left.starts(output), right.starts(output)));
    }

    private void reach(Set<Object> mine, Set<Object> theirs) {
        Deque<Pair> open = new ArrayDeque<>();
        add(mine, theirs, open);
        while (!open.isEmpty()) {
            Pair pair = open.remove();
            for (Map<String, Value> input : inputs) {
                for (Map<String, Value> output : outputs) {
                    add(
                            left.after(pair.left, input, output),
                            right.after(pair.right, input, output),
                            open);
                }
            }
        }
    }

    private void add(Set<Object> mine, Set<Object> theirs, Deque<Pair> open) {
        for (Object own : mine) {
            for (Object other : theirs) {
                Pair pair = new Pair(own, other);
                if (related.add(pair)) {
                    open.add(pair);
                }
            }
        }
    }

    private boolean isAnswered(Pair pair) {
        for (Map<String, Value> input : inputs) {
            for (Map<String, Value> output : outputs) {
                Set<Object> mine = left.after(pair.left, input, output);
                if (!isAnswered(mine, right.after(pair.right, input, output))) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean isAnswered(Set<Object> mine, Set<Object> theirs) {
        return mine.stream()
                .allMatch(own -> theirs.stream().anyMatch(o -> related.contains(new Pair(own, o))));
    }
}
