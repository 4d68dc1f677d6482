package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Where an instance of time-synchronous code is: the state of its automaton, its variables, and
 * what its inputs show. Read when its step begins, it is what the step reads.
 */
public final class AutomatonFields {
    private final Optional<Slot> state;
    private final List<Held> variables = new ArrayList<>();
    private final List<HeldMessage> inputs = new ArrayList<>();
    private final ModelValues values;

    private record Held(Slot slot, Type type) {}

    /**
     * @param automaton the only one of the component
     * @param object of the component's class
     */
    public AutomatonFields(
            Component component, Automaton automaton, Object object, CodeLayout layout) {
        CodeLayout.Place place =
                Objects.requireNonNull(layout.components().get(component.qualifiedName()));
        values = new ModelValues(layout.classes());
        // Who can only be in one state does not note it.
        state =
                automaton.states().size() > 1
                        ? Optional.of(new Slot(object, place.state()))
                        : Optional.empty();
        for (Variable each : automaton.variables()) {
            String field = Objects.requireNonNull(place.variables().get(each.name()));
            variables.add(new Held(new Slot(object, field), each.type()));
        }
        component.inputs().forEach(port -> inputs.add(HeldMessage.of(port, object, place, values)));
    }

    public Configuration configuration() {
        Value[] held = new Value[variables.size()];
        for (int i = 0; i < held.length; i++) {
            held[i] = values.of(variables.get(i).slot().get(), variables.get(i).type());
        }
        return new Configuration(state.map(Slot::getInt).orElse(0), held);
    }

    public Input input() {
        Value[] messages = new Value[inputs.size()];
        for (int i = 0; i < messages.length; i++) {
            messages[i] = inputs.get(i).read().orElse(null);
        }
        return Input.of(messages);
    }
}
