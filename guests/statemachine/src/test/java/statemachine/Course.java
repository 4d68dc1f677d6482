package statemachine;

import statemachine.ReferenceMachine.Reaction;
import statemachine.ReferenceMachine.Situation;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** What goes in, and what comes out: one slice more, since outputs have a delay. */
record Course(List<Optional<Boolean>> inputs, List<Map<String, Integer>> outputs) {
    /** Whether a machine can show it. */
    boolean isPossible(ReferenceMachine machine) {
        Set<Situation> possible = new LinkedHashSet<>();
        if (machine.start().sent().equals(outputs.get(0))) {
            possible.add(machine.start().next());
        }
        for (int i = 0; i < inputs.size(); i++) {
            Set<Situation> next = new LinkedHashSet<>();
            for (Situation each : possible) {
                for (Reaction reaction : machine.reactions(each, inputs.get(i))) {
                    if (reaction.sent().equals(outputs.get(i + 1))) {
                        next.add(reaction.next());
                    }
                }
            }
            possible = next;
        }
        return !possible.isEmpty();
    }
}
