package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A machine that reads each letter some slices later, and sends whatever it likes until then. */
public record NaiveLateMachine(NaiveMachine machine, int slices) implements NaiveMachine {
    private record State(Object inner, List<Map<String, Value>> held) {}

    @Override
    public Component component() {
        return machine.component();
    }

    @Override
    public Set<Object> starts(Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        if (output != ERROR) {
            for (Map<String, Value> any : NaiveInclusion.letters(component().outputs())) {
                machine.starts(any).forEach(inner -> found.add(new State(inner, List.of())));
            }
        }
        return found;
    }

    @Override
    public Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output) {
        State state = (State) before;
        List<Map<String, Value>> held = new ArrayList<>(state.held);
        held.add(input);
        Set<Object> found = new HashSet<>();
        if (held.size() > slices) {
            machine.after(state.inner, held.remove(0), output)
                    .forEach(inner -> found.add(new State(inner, held)));
        } else if (output != ERROR) {
            found.add(new State(state.inner, held));
        }
        return found;
    }
}
