package arcomat.analysis.search.reduction;

import arcomat.model.Automaton;
import arcomat.model.Automaton.Assignment;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;

/**
 * A component without the variables that nobody reads, but to compute such variables: what they
 * hold changes no step. One stays where to compute it may go wrong, or where a transition may only
 * be taken since there is a message for it.
 *
 * @param kept the slots of the variables that stay, by automaton
 * @param unread names of the others
 */
record UnreadVariables(Component component, List<int[]> kept, List<String> unread) {

    static UnreadVariables of(Component component) {
        if (component.platform() || !(component.body() instanceof Component.Atomic atomic)) {
            return none(component);
        }
        List<int[]> kept = new ArrayList<>();
        List<String> unread = new ArrayList<>();
        List<Automaton> automata = new ArrayList<>();
        for (Automaton automaton : atomic.automata()) {
            Set<String> own = unread(atomic, automaton);
            List<Variable> variables = automaton.variables();
            kept.add(
                    IntStream.range(0, variables.size())
                            .filter(slot -> !own.contains(variables.get(slot).name()))
                            .toArray());
            variables.stream().map(Variable::name).filter(own::contains).forEach(unread::add);
            automata.add(own.isEmpty() ? automaton : without(own, automaton));
        }
        Component smaller =
                unread.isEmpty()
                        ? component
                        : component.like(
                                component.name(),
                                component.ports(),
                                new Component.Atomic(automata, atomic.shown()),
                                component.span());
        return new UnreadVariables(smaller, kept, unread);
    }

    /** With all its variables. */
    static UnreadVariables none(Component component) {
        List<int[]> kept = new ArrayList<>();
        List<Automaton> automata = component.platform() ? List.of() : component.automata();
        for (Automaton automaton : automata) {
            kept.add(IntStream.range(0, automaton.variables().size()).toArray());
        }
        return new UnreadVariables(component, kept, List.of());
    }

    private static Set<String> unread(Component.Atomic atomic, Automaton automaton) {
        Set<String> unread = new HashSet<>();
        automaton.variables().forEach(variable -> unread.add(variable.name()));
        atomic.shown().forEach(shown -> unread.remove(shown.variable()));
        for (Automaton.Initial initial : automaton.initials()) {
            initial.sends().forEach(send -> removeRead(send.emission().values(), unread));
        }
        for (Automaton.Transition transition : automaton.transitions()) {
            transition.guard().ifPresent(guard -> removeRead(guard, unread));
            transition.matches().forEach(m -> removeRead(m.pattern().values(), unread));
            transition.sends().forEach(send -> removeRead(send.emission().values(), unread));
        }
        int before;
        do {
            before = unread.size();
            removeNeeded(automaton, unread);
        } while (unread.size() < before);
        return unread;
    }

    /** Those that another one needs, or that have to be computed. */
    private static void removeNeeded(Automaton automaton, Set<String> unread) {
        for (Automaton.Initial initial : automaton.initials()) {
            initial.assignments().forEach(each -> removeNeeded(each, unread));
        }
        for (Automaton.Transition transition : automaton.transitions()) {
            transition.assignments().forEach(each -> removeNeeded(each, unread));
        }
    }

    private static void removeNeeded(Assignment assignment, Set<String> unread) {
        Variable variable = assignment.variable();
        boolean certain =
                SureResults.isSure(assignment.value(), variable.type())
                        && assignment.value().ports().stream().allMatch(Port::total);
        if (!certain) {
            unread.remove(variable.name());
        }
        if (!unread.contains(variable.name())) {
            removeRead(assignment.value(), unread);
        }
    }

    private static void removeRead(List<Expression> all, Set<String> unread) {
        all.forEach(each -> removeRead(each, unread));
    }

    private static void removeRead(Expression e, Set<String> unread) {
        if (e instanceof Expression.VariableRead read) {
            unread.remove(read.variable().name());
        }
        e.operands().forEach(operand -> removeRead(operand, unread));
    }

    private static Automaton without(Set<String> unread, Automaton automaton) {
        List<Automaton.Initial> initials = new ArrayList<>();
        for (Automaton.Initial each : automaton.initials()) {
            initials.add(
                    new Automaton.Initial(
                            each.state(),
                            each.sends(),
                            without(unread, each.assignments()),
                            each.span()));
        }
        List<Automaton.Transition> transitions = new ArrayList<>();
        for (Automaton.Transition each : automaton.transitions()) {
            transitions.add(
                    each.with(
                            each.guard(),
                            each.matches(),
                            each.sends(),
                            without(unread, each.assignments())));
        }
        return new Automaton(
                automaton.name(),
                automaton.completion(),
                automaton.omitted(),
                automaton.violated(),
                automaton.states(),
                automaton.variables().stream().filter(v -> !unread.contains(v.name())).toList(),
                initials,
                transitions,
                automaton.places(),
                automaton.within(),
                automaton.span());
    }

    private static List<Assignment> without(Set<String> unread, List<Assignment> assignments) {
        return assignments.stream().filter(a -> !unread.contains(a.variable().name())).toList();
    }
}
