package montiarc7;

import montiarc7.grammar.MontiArc7Parser.ActionElementContext;
import montiarc7.grammar.MontiArc7Parser.BeginningContext;
import montiarc7.grammar.MontiArc7Parser.BlockContext;
import montiarc7.grammar.MontiArc7Parser.InnerTransitionElementContext;
import montiarc7.grammar.MontiArc7Parser.MachineElementContext;
import montiarc7.grammar.MontiArc7Parser.StateElementContext;
import montiarc7.grammar.MontiArc7Parser.TransitionElementContext;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The states of an automaton, those within others too, and its transitions in the order of the
 * text.
 */
final class Machine {
    /** A state, with what is done when it is entered, left, and meanwhile. */
    static final class State {
        final StateElementContext place;
        final Optional<State> around;
        final List<State> inner = new ArrayList<>();
        final Map<String, ParserRuleContext> actions = new LinkedHashMap<>();
        String name;

        State(StateElementContext place, Optional<State> around) {
            this.place = place;
            this.around = around;
            this.name = place.name().getText();
        }

        boolean isInitial() {
            return !place.beginning().isEmpty();
        }

        Optional<BlockContext> beginning() {
            return place.beginning().stream()
                    .map(BeginningContext::block)
                    .filter(each -> each != null)
                    .findFirst();
        }

        /** The state in it with which it begins, if it says so. */
        Optional<State> first() {
            return inner.stream().filter(State::isInitial).findFirst();
        }

        /** This state and those around it, from the inside out. */
        List<State> outwards() {
            List<State> all = new ArrayList<>();
            Optional<State> at = Optional.of(this);
            while (at.isPresent()) {
                all.add(at.get());
                at = at.get().around;
            }
            return all;
        }
    }

    private final List<State> states = new ArrayList<>();
    private final List<Transition> transitions = new ArrayList<>();
    private final Lacks lacks;

    Machine(List<MachineElementContext> elements, Lacks lacks) {
        this.lacks = lacks;
        add(elements, Optional.empty());
        for (State each : states) {
            if (states.stream().filter(other -> other.name.equals(each.name)).count() > 1) {
                lacks.missing(
                        Lack.STRUCTURE,
                        each.place,
                        "several states are called '%s'; give each a name of its own"
                                .formatted(each.name));
            }
        }
    }

    private void add(List<MachineElementContext> elements, Optional<State> around) {
        for (MachineElementContext each : elements) {
            if (each instanceof StateElementContext state) {
                State added = new State(state, around);
                if (state.expression() != null) {
                    lacks.note(
                            Lack.UNCHECKED,
                            state.expression(),
                            "what is to hold in '%s' is left out: runs of the converted model do not check it"
                                    .formatted(added.name));
                }
                states.add(added);
                around.ifPresent(outer -> outer.inner.add(added));
                add(state.machineElement(), Optional.of(added));
            } else if (each instanceof TransitionElementContext transition) {
                transitions.add(
                        new Transition(
                                transition,
                                transition.qname(0).getText(),
                                Optional.of(transition.qname(1).getText()),
                                transition.reaction()));
            } else if (each instanceof InnerTransitionElementContext inner && around.isPresent()) {
                transitions.add(
                        new Transition(
                                inner, around.get().name, Optional.empty(), inner.reaction()));
            } else if (each instanceof ActionElementContext action && around.isPresent()) {
                around.get().actions.put(action.kind.getText(), action.statement());
            }
        }
    }

    /** States in which it may be between two steps. */
    List<State> resting() {
        return states.stream().filter(each -> each.first().isEmpty()).toList();
    }

    /** Whether actions of states are done when it begins, and none in the slices afterwards. */
    boolean isBusyAtStartOnly() {
        List<State> begun = initial().map(Machine::beginning).orElse(List.of());
        return begun.stream().noneMatch(each -> each.actions.containsKey("do"))
                && begun.stream()
                        .anyMatch(
                                each ->
                                        each.beginning().isPresent()
                                                || each.actions.containsKey("entry"));
    }

    Optional<State> initial() {
        return states.stream()
                .filter(each -> each.around.isEmpty() && each.isInitial())
                .findFirst();
    }

    List<Transition> transitions() {
        return transitions;
    }

    /** Those that begin in a state itself. */
    List<Transition> from(State state) {
        return transitions.stream().filter(each -> simple(each.from()).equals(state.name)).toList();
    }

    /** The state that is entered; within a state this is where it begins. */
    Optional<State> target(Transition transition) {
        Optional<State> found = state(transition.to().orElse(transition.from()));
        if (found.isEmpty() || state(transition.from()).isEmpty()) {
            lacks.missing(
                    Lack.STRUCTURE,
                    transition.place(),
                    "a state that this transition names is not there");
        }
        return found;
    }

    private Optional<State> state(String name) {
        return states.stream().filter(each -> each.name.equals(simple(name))).findFirst();
    }

    private static String simple(String name) {
        return name.substring(name.lastIndexOf('.') + 1);
    }

    /** What is entered with a state, itself first, down to where it begins. */
    static List<State> beginning(State state) {
        List<State> all = new ArrayList<>();
        Optional<State> at = Optional.of(state);
        while (at.isPresent()) {
            all.add(at.get());
            at = at.get().first();
        }
        return all;
    }
}
