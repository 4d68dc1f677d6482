package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * A machine whose states are numbered as they are met, and whose steps are remembered: asked again
 * with the same letters (the objects, not their equals), it is quick.
 */
final class NumberedMachine implements NaiveMachine {
    private final NaiveMachine machine;
    private final Map<Object, Integer> numbers = new HashMap<>();
    private final List<Object> states = new ArrayList<>();
    private final List<Map<Object, Map<Object, Set<Object>>>> steps = new ArrayList<>();

    NumberedMachine(NaiveMachine machine) {
        this.machine = machine;
    }

    @Override
    public Component component() {
        return machine.component();
    }

    @Override
    public Set<Object> starts(Map<String, Value> output) {
        return numbered(machine.starts(output));
    }

    @Override
    public Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output) {
        int state = (Integer) before;
        return steps.get(state)
                .computeIfAbsent(input, key -> new IdentityHashMap<>())
                .computeIfAbsent(
                        output, key -> numbered(machine.after(states.get(state), input, output)));
    }

    private Set<Object> numbered(Set<Object> found) {
        Set<Object> numbered = new HashSet<>();
        found.forEach(state -> numbered.add(numbers.computeIfAbsent(state, this::next)));
        return numbered;
    }

    private int next(Object state) {
        states.add(state);
        steps.add(new IdentityHashMap<>());
        return states.size() - 1;
    }
}
