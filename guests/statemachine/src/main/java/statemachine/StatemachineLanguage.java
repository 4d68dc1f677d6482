package statemachine;

import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Indentation;
import arcomat.guest.Meaning;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** {@code statemachine { state a { .. } .. }}: states within states, flattened to an automaton. */
final class StatemachineLanguage implements BehaviourLanguage {
    @Override
    public String keyword() {
        return "statemachine";
    }

    @Override
    public Map<String, String> words() {
        return Map.ofEntries(
                Map.entry("statemachine", "states within states, entered and left together"),
                Map.entry("state", "a state, with what stands in it between braces"),
                Map.entry("initial", "which state is entered first"),
                Map.entry("entry", "what is done when the state is entered"),
                Map.entry("exit", "what is done when the state is left"),
                Map.entry("do", "what is done in each slice in which the state stays"),
                Map.entry("history", "back to the state that was left here last"),
                Map.entry("deepHistory", "back to all states that were left here last"),
                Map.entry("variable", "what the machine remembers besides its state"),
                Map.entry("priority", "whose transitions come first, those inside or outside"),
                Map.entry("inner", "transitions of inner states come first"),
                Map.entry("outer", "transitions of outer states come first"));
    }

    @Override
    public List<String> codes() {
        return Arrays.stream(Mistake.values()).map(Mistake::code).toList();
    }

    @Override
    public Optional<String> layout(Written behaviour) {
        return Optional.of(Indentation.of(behaviour.body().text()));
    }

    @Override
    public void translate(Written behaviour, Meaning meaning) {
        Machine machine;
        try {
            machine = MachineReader.read(behaviour);
        } catch (UnreadableText e) {
            e.tell(meaning);
            return;
        }
        StateTree states = StateTree.of(machine.root());
        new MachineLaws(machine, states, meaning).check();
        if (meaning.problems().isEmpty()) {
            new Flattening(machine, states, meaning).write();
        }
    }
}
