package arcomat.analysis;

import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Behaviour.JointReaction;
import arcomat.semantics.Configuration;
import arcomat.semantics.Input;
import arcomat.semantics.Output;
import arcomat.semantics.Reaction;

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
final class NaiveInclusion {
    /** An output that ends the run. */
    private static final Map<String, Value> ERROR = Map.of("error", new Value.BooleanValue(true));

    private record Node(List<Configuration> left, Set<List<Configuration>> right) {}

    private final Behaviour left;
    private final Behaviour right;
    private final List<Map<String, Value>> inputs;
    private final List<Map<String, Value>> outputs;

    NaiveInclusion(Promise left, Promise right) {
        this.left = left.behaviour();
        this.right = right.behaviour();
        this.inputs = letters(left.component().inputs());
        this.outputs = new ArrayList<>(letters(right.component().outputs()));
        this.outputs.add(ERROR);
    }

    /** The number of inputs after which the left side may do what the right one forbids. */
    OptionalInt shortestFailure(int most) {
        Set<Node> level = new HashSet<>();
        Set<Node> seen = new HashSet<>();
        for (Map<String, Value> output : outputs) {
            Set<List<Configuration>> mine = starts(left, output);
            Set<List<Configuration>> theirs = starts(right, output);
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
                Set<List<Configuration>> mine = after(left, Set.of(node.left), input, output);
                if (mine.isEmpty()) {
                    continue;
                }
                Set<List<Configuration>> theirs = after(right, node.right, input, output);
                if (theirs.isEmpty()) {
                    return true;
                }
                mine.forEach(each -> next.add(new Node(each, theirs)));
            }
        }
        return false;
    }

    private static Set<List<Configuration>> starts(Behaviour side, Map<String, Value> output) {
        Set<List<Configuration>> found = new HashSet<>();
        side.starts().stream()
                .filter(start -> allows(side, start.output(), output))
                .forEach(s -> found.add(s.starts().stream().map(b -> b.configuration()).toList()));
        return found;
    }

    private static Set<List<Configuration>> after(
            Behaviour side,
            Set<List<Configuration>> before,
            Map<String, Value> input,
            Map<String, Value> output) {
        Set<List<Configuration>> found = new HashSet<>();
        Map<String, Value> messages = new LinkedHashMap<>(input);
        messages.values().removeIf(value -> value == null);
        Input read = Input.of(side.component(), Letter.of(messages));
        for (List<Configuration> each : before) {
            for (JointReaction reaction : side.reactions(each, read)) {
                List<Configuration> next =
                        reaction.reactions().stream().map(Reaction::next).toList();
                boolean error = next.contains(Configuration.ERROR);
                if (each.contains(Configuration.ERROR)) {
                    continue;
                }
                boolean chaos = each.stream().allMatch(one -> one == Configuration.CHAOS);
                if (output == ERROR
                        ? error || chaos
                        : !error && allows(side, reaction.output(), output)) {
                    found.add(next);
                }
            }
        }
        return found;
    }

    /** Ports that the letter does not know are somebody else's business. */
    private static boolean allows(Behaviour side, Output output, Map<String, Value> letter) {
        if (letter == ERROR) {
            return false;
        }
        List<Port> ports = side.component().outputs();
        for (int i = 0; i < ports.size(); i++) {
            String name = ports.get(i).name();
            if (letter.containsKey(name)) {
                Value value = letter.get(name);
                if (!output.ports().get(i).allows(value == null ? List.of() : List.of(value))) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Every letter; null is silence. */
    private static List<Map<String, Value>> letters(List<Port> ports) {
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

    private static List<Value> values(Port port) {
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
