package arcomat.simulate;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Trace;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;
import arcomat.semantics.Configuration;
import arcomat.semantics.Fault;
import arcomat.semantics.Input;
import arcomat.semantics.Output;
import arcomat.semantics.Reaction;
import arcomat.semantics.Sent;
import arcomat.semantics.Start;
import arcomat.semantics.StepRelation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;

/**
 * Watches the ports of a time-synchronous component for one of its automata: the set of its runs
 * that agree with what was seen. Generated monitors do the same, see {@code arcomat.rt.Monitor}.
 */
public final class Watch {
    /**
     * A way on.
     *
     * @param promised per output port, what is to be seen: with delay 1 in the next slice
     */
    private record Run(String cause, Configuration configuration, Output promised) {}

    private final StepRelation relation;
    private final String requirement;
    private final List<Port> outputs;
    private List<Run> runs = new ArrayList<>();
    private String problem = "";
    private boolean satisfied;
    private boolean violated;
    private int slice;
    private OptionalInt satisfiedFrom = OptionalInt.empty();

    /**
     * @param automaton one of those of the component
     * @param arguments one per parameter
     */
    public Watch(Component component, Automaton automaton, List<Value> arguments) {
        relation = Behaviour.of(component, List.of(automaton), arguments).relations().get(0);
        requirement = component.title(automaton) + " (line " + line(automaton) + ")";
        outputs = component.outputs();
        for (Start start : relation.starts()) {
            int line = start.initial().span().startPosition().line();
            String cause = "line " + line + ": initial " + state(start.initial().state());
            runs.add(new Run(cause, start.configuration(), start.output()));
        }
    }

    private static int line(Automaton automaton) {
        return automaton.span().startPosition().line();
    }

    private String state(int state) {
        return relation.automaton().states().get(state);
    }

    /** The component, with the automaton where it is one of several, and the line. */
    public String requirement() {
        return requirement;
    }

    /** The slice from which on the requirement promises nothing any more. */
    public OptionalInt satisfiedFrom() {
        return satisfiedFrom;
    }

    /**
     * Judges a slice. After a violation nothing is judged any more.
     *
     * @param shown what the outputs show in the slice; ports of others are ignored
     */
    public Optional<Violation> see(Letter inputs, Letter shown) {
        Optional<Violation> found = Optional.empty();
        if (!satisfied && !violated) {
            found = keep(shown, true);
            runs.forEach(run -> satisfied |= run.configuration == Configuration.CHAOS);
            if (satisfied) {
                satisfiedFrom = OptionalInt.of(slice);
            } else if (found.isEmpty()) {
                step(inputs);
                found = keep(shown, false);
            }
        }
        violated |= found.isPresent();
        slice++;
        return found;
    }

    private Optional<Violation> keep(Letter shown, boolean late) {
        List<Run> kept = runs.stream().filter(run -> agrees(run, shown, late)).toList();
        Optional<Violation> violation = Optional.empty();
        if (kept.isEmpty()) {
            String text = "slice " + slice + ": " + requirement + accusation(shown, late);
            violation = Optional.of(new Violation(slice, relation.automaton(), text));
        }
        runs = kept;
        return violation;
    }

    private boolean agrees(Run run, Letter shown, boolean late) {
        for (int i = 0; i < outputs.size(); i++) {
            Port port = outputs.get(i);
            if (isLate(port) == late
                    && !run.promised.ports().get(i).allows(shown.messages(port.name()))) {
                return false;
            }
        }
        return true;
    }

    private static boolean isLate(Port port) {
        return port.delay() > 0;
    }

    private void step(Letter letter) {
        Set<Configuration> before = new LinkedHashSet<>();
        runs.forEach(run -> before.add(run.configuration));
        Input input = Input.of(relation.component(), letter);
        runs = new ArrayList<>();
        for (Configuration configuration : before) {
            try {
                for (Reaction reaction : relation.reactions(configuration, input)) {
                    go(configuration, reaction);
                }
            } catch (Fault fault) {
                problem = " goes wrong: " + fault.getMessage();
            }
        }
    }

    private void go(Configuration before, Reaction reaction) {
        if (reaction.next() == Configuration.ERROR) {
            problem = " forbids this input in " + state(before.state());
            return;
        }
        String cause;
        if (reaction.cause() instanceof Trace.Taken taken) {
            Automaton.Transition transition = taken.transition();
            cause =
                    "line %d: %s -> %s"
                            .formatted(
                                    transition.span().startPosition().line(),
                                    state(transition.source()),
                                    state(transition.target()));
        } else {
            String completion = relation.automaton().completion().name().toLowerCase(Locale.ROOT);
            cause = "no transition fits in " + state(before.state()) + ", completion " + completion;
        }
        runs.add(new Run(cause, reaction.next(), reaction.output()));
    }

    private String accusation(Letter shown, boolean late) {
        if (runs.isEmpty()) {
            return problem;
        }
        Map<String, Integer> judged = new LinkedHashMap<>();
        for (int i = 0; i < outputs.size(); i++) {
            int position = i;
            boolean said =
                    runs.stream()
                            .anyMatch(
                                    run ->
                                            !(run.promised.ports().get(position)
                                                    instanceof Sent.Anything));
            if (said && isLate(outputs.get(i)) == late) {
                judged.put(outputs.get(i).name(), i);
            }
        }
        List<String> seen = new ArrayList<>();
        judged.keySet()
                .forEach(port -> seen.add(port + " = " + new Sent.Messages(shown.messages(port))));
        Set<String> allowed = new LinkedHashSet<>();
        for (Run run : runs) {
            List<String> promised = new ArrayList<>();
            judged.forEach((port, i) -> promised.add(port + " = " + run.promised.ports().get(i)));
            allowed.add(String.join(", ", promised) + " (" + run.cause + ")");
        }
        return " forbids "
                + String.join(", ", seen)
                + "; it allows "
                + String.join(" or ", allowed);
    }
}
