package arcomat.analysis;

import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Promise;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Inclusion of traces by trying every letter of input and output, length by length. Slow and
 * simple: it shares nothing with the engine but the step relation. For ports of enums and Booleans.
 */
public final class NaiveInclusion {
    private record Node(Object left, Set<Object> right) {}

    final NaiveMachine left;
    final NaiveMachine right;
    final List<Map<String, Value>> inputs;
    final List<Map<String, Value>> outputs;

    public NaiveInclusion(Promise left, Promise right) {
        this(left, right, NaiveMachine.of(right));
    }

    /**
     * @param machine the right side, or what it is made into
     */
    public NaiveInclusion(Promise left, Promise right, NaiveMachine machine) {
        List<Port> compared = right.component().outputs();
        Set<String> late = NaiveShownMachine.late(left, right, compared);
        Set<String> otherLate = NaiveShownMachine.late(right, left, compared);
        Set<String> mixed = new HashSet<>(late);
        mixed.addAll(otherLate);
        NaiveMachine own = NaiveMachine.of(left);
        this.left = new NumberedMachine(new NaiveShownMachine(own, late, mixed));
        this.right = new NumberedMachine(new NaiveShownMachine(machine, otherLate, mixed));
        this.inputs = letters(left.component().inputs());
        this.outputs = new ArrayList<>(letters(shown(compared, mixed)));
        for (Map<String, Value> seen :
                letters(
                        shown(compared, mixed).stream()
                                .filter(port -> mixed.contains(port.name()))
                                .toList())) {
            Map<String, Value> error = new LinkedHashMap<>(seen);
            error.putAll(NaiveMachine.ERROR);
            this.outputs.add(error);
        }
    }

    /** Before the first slice, also a total port is silent to whoever looks. */
    private static List<Port> shown(List<Port> ports, Set<String> mixed) {
        return ports.stream()
                .map(
                        port ->
                                mixed.contains(port.name())
                                        ? new Port(
                                                port.name(),
                                                port.direction(),
                                                port.type(),
                                                false,
                                                port.delay(),
                                                port.latched(),
                                                port.span())
                                        : port)
                .toList();
    }

    /** The number of inputs after which the left side may do what the right one forbids. */
    public OptionalInt shortestFailure(int most) {
        Set<Node> level = new HashSet<>();
        Set<Node> seen = new HashSet<>();
        for (Map<String, Value> output : outputs) {
            Set<Object> mine = left.starts(output);
            Set<Object> theirs = right.starts(output);
            if (!mine.isEmpty() && theirs.isEmpty()) {
                return OptionalInt.of(0);
            }
            mine.forEach(each -> level.add(new Node(each, theirs)));
        }
        Set<Node> current = level;
        for (int length = 1; length <= most; length++) {
            Set<Node> next = new HashSet<>();
            for (Node node : current) {
                if (seen.add(node) && fails(node, next)) {
                    return OptionalInt.of(length);
                }
            }
            current = next;
        }
        return OptionalInt.empty();
    }

    private boolean fails(Node node, Set<Node> next) {
        for (Map<String, Value> input : inputs) {
            for (Map<String, Value> output : outputs) {
                Set<Object> mine = left.after(node.left, input, output);
                if (mine.isEmpty()) {
                    continue;
                }
                Set<Object> theirs = after(node.right, input, output);
                if (theirs.isEmpty()) {
                    return true;
                }
                mine.forEach(each -> next.add(new Node(each, theirs)));
            }
        }
        return false;
    }

    private Set<Object> after(
            Set<Object> before, Map<String, Value> input, Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        before.forEach(each -> found.addAll(right.after(each, input, output)));
        return found;
    }

    /** Every letter; null is silence. */
    public static List<Map<String, Value>> letters(List<Port> ports) {
        List<Map<String, Value>> letters = List.of(Map.of());
        for (Port port : ports) {
            List<Map<String, Value>> longer = new ArrayList<>();
            for (Map<String, Value> letter : letters) {
                for (Value value : values(port)) {
                    Map<String, Value> copy = new LinkedHashMap<>(letter);
                    copy.put(port.name(), value);
                    longer.add(copy);
                }
            }
            letters = longer;
        }
        return letters;
    }

    /** Every message, and null where there need not be one. */
    static List<Value> values(Port port) {
        List<Value> values = new ArrayList<>();
        if (!port.total()) {
            values.add(null);
        }
        if (port.type() instanceof Type.EnumType enumeration) {
            for (int i = 0; i < enumeration.constants().size(); i++) {
                values.add(new Value.EnumValue(enumeration, i));
            }
        } else {
            values.add(new Value.BooleanValue(false));
            values.add(new Value.BooleanValue(true));
        }
        return values;
    }
}
