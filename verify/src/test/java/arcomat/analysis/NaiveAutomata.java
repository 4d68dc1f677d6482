package arcomat.analysis;

import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** One automaton, or a conjunction of some. A state has a configuration of each. */
record NaiveAutomata(ComponentSemantics behaviour) implements NaiveMachine {
    @Override
    public Component component() {
        return behaviour.component();
    }

    @Override
    public Set<Object> starts(Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        behaviour.starts().stream()
                .filter(start -> allows(start.output(), output))
                .forEach(s -> found.add(s.starts().stream().map(b -> b.configuration()).toList()));
        return found;
    }

    @Override
    @SuppressWarnings("unchecked")
    public Set<Object> after(Object before, Map<String, Value> input, Map<String, Value> output) {
        Set<Object> found = new HashSet<>();
        List<Configuration> state = (List<Configuration>) before;
        if (state.contains(Configuration.ERROR)) {
            return found;
        }
        Prospect prospect = behaviour.prospect(state, read(component(), input));
        if (output == ERROR && !prospect.errors().isEmpty()) {
            found.add(List.of(Configuration.ERROR));
        }
        for (JointReaction reaction : prospect.reactions()) {
            if (output != ERROR && allows(reaction.output(), output)) {
                found.add(reaction.next());
            }
        }
        return found;
    }

    static Input read(Component component, Map<String, Value> letter) {
        Map<String, Value> messages = new LinkedHashMap<>(letter);
        messages.values().removeIf(value -> value == null);
        return Input.of(component, Letter.of(messages));
    }

    /** Ports that the letter does not know are somebody else's business. */
    private boolean allows(Output output, Map<String, Value> letter) {
        if (letter == ERROR) {
            return false;
        }
        List<Port> ports = component().outputs();
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
}
