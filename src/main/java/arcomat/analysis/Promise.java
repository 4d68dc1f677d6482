package arcomat.analysis;

import arcomat.analysis.engine.RunErrors;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.Behaviour;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * One side of a comparison: a component, or some automata on it.
 *
 * @param arguments one per parameter
 * @param automata those that count; empty for a composition, which is what its parts make it
 */
public record Promise(Component component, List<Value> arguments, List<Automaton> automata) {
    public Promise {
        arguments = List.copyOf(arguments);
        automata = List.copyOf(automata);
    }

    /** What a component does. */
    public static Promise of(Component component, List<Value> arguments) {
        List<Automaton> automata =
                component.body() instanceof Component.Atomic atomic ? atomic.automata() : List.of();
        return new Promise(component, arguments, automata);
    }

    /** What the automata on a decomposed component ask of it. */
    public static Promise required(Component component, List<Value> arguments) {
        return new Promise(component, arguments, component.requirements());
    }

    /** The same with one automaton only, by its name. */
    public Optional<Promise> only(String automaton) {
        List<Automaton> named =
                automataOf(component).stream().filter(a -> a.name().equals(automaton)).toList();
        return named.isEmpty()
                ? Optional.empty()
                : Optional.of(new Promise(component, arguments, named));
    }

    /** All automata on a component, those that ask something of a decomposed one too. */
    public static List<Automaton> automataOf(Component component) {
        return component.body() instanceof Component.Atomic atomic
                ? atomic.automata()
                : component.requirements();
    }

    /** The same with another completion. */
    public Promise with(Automaton.Completion completion) {
        List<Automaton> changed = automata.stream().map(a -> a.with(completion)).toList();
        return new Promise(component, arguments, changed);
    }

    /** Each automaton on its own: a conjunction is kept if each of them is. */
    public List<Promise> each() {
        return automata.size() < 2
                ? List.of(this)
                : automata.stream()
                        .map(a -> new Promise(component, arguments, List.of(a)))
                        .toList();
    }

    /**
     * What another side is compared with, one after the other. An error of one automaton ends the
     * run of all; where there may be one, the conjunction stays whole.
     */
    List<Promise> comparedApart() {
        return automata.stream().anyMatch(RunErrors::arePossible) ? List.of(this) : each();
    }

    boolean isComposition() {
        return component.isComposite() && automata.isEmpty();
    }

    Behaviour behaviour() {
        return Behaviour.of(component, automata, arguments);
    }

    /** The component's name, its arguments, and the automaton's where it is one of several. */
    public String title() {
        boolean part = automata.size() == 1 && automataOf(component).size() > 1;
        String name = part ? automata.get(0).name() : "";
        return component.qualifiedName() + listed() + (name.isEmpty() ? "" : "#" + name);
    }

    private String listed() {
        return arguments.isEmpty()
                ? ""
                : arguments.stream()
                        .map(Value::toString)
                        .collect(Collectors.joining(", ", "(", ")"));
    }
}
