package statemachine;

import statemachine.ReferenceMachine.Reaction;
import statemachine.ReferenceMachine.Situation;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * All that a reference may do, step by step: an automaton that has a state for each situation and
 * says everything about it.
 *
 * @param start what is sent then
 * @param numbers of the situations; 0 is the first
 */
record UnfoldedMachine(
        Map<String, Integer> start, Map<Situation, Integer> numbers, Set<Step> steps) {
    private static final List<Optional<Boolean>> INPUTS =
            List.of(Optional.empty(), Optional.of(true), Optional.of(false));

    record Step(int from, Optional<Boolean> a, Map<String, Integer> sent, int to) {}

    /**
     * @param most situations; with more there is none
     */
    static Optional<UnfoldedMachine> of(ReferenceMachine machine, int most) {
        Reaction start = machine.start();
        Map<Situation, Integer> numbers = new LinkedHashMap<>(Map.of(start.next(), 0));
        Set<Step> steps = new LinkedHashSet<>();
        Deque<Situation> open = new ArrayDeque<>(numbers.keySet());
        while (!open.isEmpty()) {
            Situation current = open.remove();
            for (Optional<Boolean> a : INPUTS) {
                for (Reaction each : machine.reactions(current, a)) {
                    if (numbers.putIfAbsent(each.next(), numbers.size()) == null) {
                        open.add(each.next());
                    }
                    int from = numbers.get(current);
                    steps.add(new Step(from, a, each.sent(), numbers.get(each.next())));
                }
            }
            if (numbers.size() > most) {
                return Optional.empty();
            }
        }
        return Optional.of(new UnfoldedMachine(start.sent(), numbers, steps));
    }

    /**
     * As a component.
     *
     * @param name with what may follow it
     */
    String text(String name) {
        StringBuilder text = new StringBuilder();
        text.append("component ").append(name).append(" {\n").append(DrawnMachine.ports());
        text.append("<<completion = \"ignore\">> automaton {\n");
        numbers.values().forEach(number -> text.append("state q%d;\n".formatted(number)));
        text.append("initial q0").append(output(start)).append(";\n");
        for (Step each : steps) {
            String a = each.a().map(String::valueOf).orElse("--");
            text.append("q%d -> q%d {a == %s}".formatted(each.from(), each.to(), a));
            text.append(output(each.sent())).append(";\n");
        }
        return text.append("}\n}\n").toString();
    }

    private static String output(Map<String, Integer> sent) {
        return sent.isEmpty()
                ? ""
                : sent.entrySet().stream()
                        .map(each -> each.getKey() + " = " + each.getValue())
                        .collect(Collectors.joining(", ", " / {", "}"));
    }
}
