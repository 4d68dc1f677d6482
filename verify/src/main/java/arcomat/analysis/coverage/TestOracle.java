package arcomat.analysis.coverage;

import arcomat.analysis.search.Budget;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.StreamTest;
import arcomat.model.Value;
import arcomat.semantics.Promise;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.JointReaction;
import arcomat.semantics.automaton.ComponentSemantics.JointStart;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.expression.Output;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;

/** Whether an atomic component that works slice by slice allows what a test expects. */
final class TestOracle {
    private final Component component;
    private final ComponentSemantics behaviour;
    private final Budget budget;

    TestOracle(Promise promise, Budget budget) {
        this.component = promise.component();
        this.behaviour =
                ComponentSemantics.of(promise.component(), promise.automata(), promise.arguments());
        this.budget = budget;
    }

    boolean allows(StreamTest test) {
        return !places(test.inputs(), test.expected()).isEmpty();
    }

    /** Whether it may promise nothing any more at the end. */
    boolean isLost(List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        return places(inputs, expected).stream()
                .anyMatch(place -> place.contains(Configuration.CHAOS));
    }

    private Set<List<Configuration>> places(
            List<Letter> inputs, Map<String, List<List<Value>>> expected) {
        Set<List<Configuration>> places = new LinkedHashSet<>();
        for (JointStart start : behaviour.starts(budget::insist)) {
            if (allows(start.output(), expected, 0, true)) {
                places.add(start.configurations());
            }
        }
        for (int slice = 0; slice < inputs.size() && !places.isEmpty(); slice++) {
            Input input = Input.of(component, inputs.get(slice));
            Set<List<Configuration>> next = new LinkedHashSet<>();
            for (List<Configuration> place : places) {
                budget.insist();
                for (JointReaction reaction :
                        behaviour.prospect(place, input, budget::insist).reactions()) {
                    if (allows(reaction.output(), expected, slice, false)) {
                        next.add(reaction.next());
                    }
                }
            }
            places = next;
        }
        return places;
    }

    /** What is sent in reaction to a slice is seen there, or in the next one. */
    private boolean allows(
            Output output, Map<String, List<List<Value>>> expected, int slice, boolean start) {
        List<Port> ports = component.outputs();
        for (int i = 0; i < ports.size(); i++) {
            Port port = ports.get(i);
            int seen = start ? 0 : slice + port.delay();
            boolean shown = !start || port.delay() > 0;
            if (shown && !output.ports().get(i).allows(at(expected, port, seen))) {
                return false;
            }
        }
        return true;
    }

    private static List<Value> at(Map<String, List<List<Value>>> expected, Port port, int slice) {
        List<List<Value>> stream = Objects.requireNonNull(expected.get(port.name()));
        return slice < stream.size() ? stream.get(slice) : List.of();
    }
}
