package statemachine;

import arcomat.guest.BehaviourLanguage;
import arcomat.guest.Meaning;

import java.util.Arrays;
import java.util.List;

/** {@code statemachine { state a { .. } .. }}: states within states, flattened to an automaton. */
final class StatemachineLanguage implements BehaviourLanguage {
    @Override
    public String keyword() {
        return "statemachine";
    }

    @Override
    public List<String> codes() {
        return Arrays.stream(Mistake.values()).map(Mistake::code).toList();
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
