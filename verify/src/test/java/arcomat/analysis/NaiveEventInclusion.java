package arcomat.analysis;

import arcomat.analysis.NaiveEvents.Step;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.expression.Sent;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Inclusion of the runs of event-driven sides, event by event and with all that may be sent written
 * out; without the engine.
 */
public final class NaiveEventInclusion {

    /**
     * @param right where the right side may be after what was sent so far
     * @param held what latched ports hold
     */
    private record Node(Object left, Set<Object> right, Map<String, Value> held) {}

    private final NaiveEvents left;
    private final NaiveEvents right;
    private final List<Port> compared;
    private final Set<Node> seen = new HashSet<>();

    public NaiveEventInclusion(Promise left, Promise right) {
        this.left = new NaiveEvents(left);
        this.right = new NaiveEvents(right);
        this.compared = right.component().outputs();
    }

    /** The number of events after which the left side may do what the right one forbids. */
    public OptionalInt shortestFailure(int most) {
        List<Node> level = new ArrayList<>();
        if (fails(left.starts(), right.starts(), Map.of(), level)) {
            return OptionalInt.of(0);
        }
        for (int length = 1; length <= most; length++) {
            List<Node> next = new ArrayList<>();
            for (Node node : level) {
                for (Map<String, Value> letter : letters(left.component(), node.held)) {
                    List<Step> theirs = new ArrayList<>();
                    Map<String, Value> own = new LinkedHashMap<>(letter);
                    own.keySet().removeIf(name -> right.component().port(name).isEmpty());
                    node.right.forEach(each -> theirs.addAll(right.steps(each, own)));
                    Map<String, Value> held = new LinkedHashMap<>(letter);
                    held.keySet().removeIf(name -> !isLatched(name));
                    if (fails(left.steps(node.left, letter), theirs, held, next)) {
                        return OptionalInt.of(length);
                    }
                }
            }
            level = next;
        }
        return OptionalInt.empty();
    }

    private boolean isLatched(String name) {
        return left.component().port(name).orElseThrow().latched();
    }

    private boolean fails(
            List<Step> mine, List<Step> theirs, Map<String, Value> held, List<Node> next) {
        for (Map<String, List<Value>> output : outputs(mine, theirs)) {
            Set<Object> allowed = after(theirs, output);
            for (Object each : after(mine, output)) {
                if (allowed.isEmpty()) {
                    return true;
                }
                Node node = new Node(each, allowed, held);
                if (seen.add(node)) {
                    next.add(node);
                }
            }
        }
        boolean mayEnd = theirs.stream().anyMatch(step -> step.output() == null);
        return !mayEnd && mine.stream().anyMatch(step -> step.output() == null);
    }

    private static Set<Object> after(List<Step> steps, Map<String, List<Value>> output) {
        Set<Object> after = new HashSet<>();
        for (Step step : steps) {
            if (step.output() != null
                    && output.entrySet().stream()
                            .allMatch(e -> step.output().get(e.getKey()).allows(e.getValue()))) {
                after.add(step.next());
            }
        }
        return after;
    }

    private List<Map<String, List<Value>>> outputs(List<Step> mine, List<Step> theirs) {
        List<Map<String, List<Value>>> outputs = List.of(Map.of());
        for (Port port : compared) {
            List<Map<String, List<Value>>> longer = new ArrayList<>();
            for (List<Value> list : candidates(port, mine, theirs)) {
                for (Map<String, List<Value>> output : outputs) {
                    Map<String, List<Value>> copy = new LinkedHashMap<>(output);
                    copy.put(port.name(), list);
                    longer.add(copy);
                }
            }
            outputs = longer;
        }
        return outputs;
    }

    /** Lists of messages that are worth trying on a port: the mentioned ones, and a longer one. */
    private static List<List<Value>> candidates(Port port, List<Step> mine, List<Step> theirs) {
        List<List<Value>> lists = new ArrayList<>(List.of(List.of()));
        SomeValues.of(port.type()).forEach(value -> lists.add(List.of(value)));
        int longest = 1;
        for (List<Step> steps : List.of(mine, theirs)) {
            for (Step step : steps) {
                if (step.output() != null
                        && step.output().get(port.name()) instanceof Sent.Messages messages
                        && !lists.contains(messages.values())) {
                    lists.add(messages.values());
                    longest = Math.max(longest, messages.values().size());
                }
            }
        }
        lists.add(Collections.nCopies(longest + 1, SomeValues.of(port.type()).get(0)));
        return lists;
    }

    /** Every event with everything that latched ports may hold; what they hold does not go away. */
    private static List<Map<String, Value>> letters(Component component, Map<String, Value> held) {
        List<Map<String, Value>> letters = new ArrayList<>();
        for (Port port : component.inputs()) {
            if (!port.latched()) {
                SomeValues.of(port.type()).forEach(v -> letters.add(Map.of(port.name(), v)));
            }
        }
        List<Map<String, Value>> all = letters;
        for (Port port : component.inputs()) {
            if (port.latched()) {
                all = holding(all, port, held.containsKey(port.name()));
            }
        }
        return all;
    }

    private static List<Map<String, Value>> holding(
            List<Map<String, Value>> letters, Port port, boolean held) {
        List<Map<String, Value>> longer =
                new ArrayList<>(held ? List.<Map<String, Value>>of() : letters);
        for (Map<String, Value> letter : letters) {
            for (Value value : SomeValues.of(port.type())) {
                Map<String, Value> copy = new LinkedHashMap<>(letter);
                copy.put(port.name(), value);
                longer.add(copy);
            }
        }
        return longer;
    }
}
