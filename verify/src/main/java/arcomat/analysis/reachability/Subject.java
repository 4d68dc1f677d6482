package arcomat.analysis.reachability;

import arcomat.graph.Digraph;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.value.SmallType;
import arcomat.semantics.value.TooManyWays;

import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;

/**
 * The automaton that is examined.
 *
 * @param arguments one per parameter of the component
 * @param relation its steps, with the ports that it decides about
 * @param preconditions one per transition
 */
public record Subject(
        Component component,
        Automaton automaton,
        List<Value> arguments,
        StepRelation relation,
        List<Preconditions> preconditions) {

    /**
     * @throws arcomat.semantics.expression.Fault where constants or initial values go wrong
     */
    public static Subject of(Component component, Automaton automaton, List<Value> arguments) {
        if (component.isOnlyRun()) {
            throw new TooManyWays();
        }
        ComponentSemantics behaviour =
                ComponentSemantics.of(component, List.of(automaton), arguments);
        return new Subject(
                component,
                automaton,
                arguments,
                behaviour.relations().get(0),
                Preconditions.of(component.profile(), automaton));
    }

    /** The transitions whose guards negate a message without a thought of its silence. */
    public List<Integer> silenceable() {
        return IntStream.range(0, preconditions.size())
                .filter(each -> !preconditions.get(each).negations().isEmpty())
                .boxed()
                .toList();
    }

    /** Whether a variable has so many values that trying them may not end. */
    public boolean isWide() {
        return automaton.variables().stream().anyMatch(variable -> isWide(variable.type()));
    }

    /** Whether a type has so many values. */
    public static boolean isWide(Type type) {
        return type instanceof Type.IntegerType integer
                ? !integer.ranged()
                : SmallType.values(type).isEmpty();
    }

    /** Whether a port carries a message whenever the automaton is asked for a step. */
    public boolean isAlwaysThere(Port port) {
        boolean timed = component.profile() == Component.Profile.TIME_SYNCHRONOUS;
        return timed && port.total() || port.first().isPresent();
    }

    /** The ports that have nothing until their first message, and something ever after. */
    public List<Port> latchable() {
        return component.profile() == Component.Profile.TIME_SYNCHRONOUS
                ? List.of()
                : component.inputs().stream()
                        .filter(port -> port.latched() && !isAlwaysThere(port))
                        .toList();
    }

    /** The states that transitions lead to from a beginning, whatever their guards say. */
    public static BitSet connected(Automaton automaton) {
        Digraph states = new Digraph(automaton.states().size());
        automaton.transitions().forEach(each -> states.addEdge(each.source(), each.target()));
        int before = states.addNode();
        automaton.initials().forEach(initial -> states.addEdge(before, initial.state()));
        return states.reachableFrom(before);
    }

    public Automaton.Transition transition(int index) {
        return automaton.transitions().get(index);
    }

    /**
     * The ways through the statements of a transition, itself included: what was written at the
     * same place and leads from and to the same states.
     */
    public List<Integer> ways(int transition) {
        Automaton.Transition one = transition(transition);
        return IntStream.range(0, automaton.transitions().size())
                .filter(
                        each ->
                                transition(each).span().equals(one.span())
                                        && transition(each).source() == one.source()
                                        && transition(each).target() == one.target())
                .boxed()
                .toList();
    }

    public String state(int index) {
        return automaton.states().get(index);
    }

    /** {@code driving -> waiting (line 12)}. */
    public String place(int transition) {
        return move(transition)
                + " (line "
                + transition(transition).span().startPosition().line()
                + ")";
    }

    /** {@code driving -> waiting}. */
    public String move(int transition) {
        Automaton.Transition move = transition(transition);
        return state(move.source()) + " -> " + state(move.target());
    }
}
