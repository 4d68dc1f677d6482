package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.network.Network;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;

/**
 * A machine whose messages on some ports stand in the slice in which they are seen. An error is a
 * letter with what earlier reactions still show on those ports.
 *
 * @param late ports on which this machine sends with delay, and the other one without
 * @param mixed ports on which one of both does
 */
public record NaiveShownMachine(NaiveMachine machine, Set<String> late, Set<String> mixed)
        implements NaiveMachine {

    /**
     * @param made what was sent on late ports a slice ago
     */
    private record State(Object inner, Map<String, Value> made) {}

    /** Ports of the right side on which only one of both sends with delay. */
    public static Set<String> late(Promise side, Promise other, List<Port> compared) {
        Set<String> late = new TreeSet<>();
        for (Port port : compared) {
            if (delay(side, port.name()) == 1 && delay(other, port.name()) == 0) {
                late.add(port.name());
            }
        }
        return late;
    }

    /** The delay of whoever sends what is seen on a port; -1 where nobody does. */
    private static int delay(Promise side, String port) {
        if (!side.isComposition()) {
            return side.component().port(port).map(Port::delay).orElse(-1);
        }
        Network network = Network.of(side.component(), side.arguments());
        return network.outputs().stream()
                .filter(each -> each.name().equals(port) && each.signal() >= 0)
                .map(each -> network.delayed().contains(each.signal()) ? 1 : 0)
                .findAny()
                .orElse(-1);
    }

    @Override
    public Component component() {
        return machine.component();
    }

    @Override
    public Set<Object> starts(Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        boolean error = output.containsKey("error");
        if (!error && late.stream().allMatch(port -> output.get(port) == null)) {
            for (Map<String, Value> made : made()) {
                machine.starts(with(output, made)).forEach(s -> found.add(new State(s, made)));
            }
        }
        return found;
    }

    @Override
    public Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output) {
        State state = (State) before;
        boolean error = output.containsKey("error");
        Set<Object> found = new HashSet<>();
        for (String port : mixed) {
            Value seen = late.contains(port) ? state.made.get(port) : null;
            boolean tells = late.contains(port) || error;
            if (tells && !same(seen, output.get(port))) {
                return found;
            }
        }
        for (Map<String, Value> made : error ? List.of(new HashMap<String, Value>()) : made()) {
            machine.after(state.inner, input, error ? ERROR : with(output, made))
                    .forEach(each -> found.add(new State(each, made)));
        }
        return found;
    }

    private static boolean same(Value one, Value other) {
        return one == null ? other == null : one.equals(other);
    }

    private List<Map<String, Value>> made() {
        return NaiveInclusion.letters(
                component().outputs().stream().filter(p -> late.contains(p.name())).toList());
    }

    private static Map<String, Value> with(Map<String, Value> output, Map<String, Value> made) {
        Map<String, Value> both = new LinkedHashMap<>(output);
        both.putAll(made);
        return both;
    }
}
