package arcomat.analysis.reachability;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.semantics.expression.Guards;

import java.util.ArrayList;
import java.util.List;

/**
 * What has to be so of the present configuration and letter for something to happen to a transition
 * out of the present state: weakest preconditions, as expressions.
 *
 * @param enabled it may be taken
 * @param negations in its guard, of messages that may not be there, without a thought of that
 * @param enabledButForSilence it may be taken, but that the negations may have nothing to negate
 * @param wrapsInGuard an integer of its guard wraps around
 * @param wrapsInEffect an integer of what it sends and assigns does
 * @param dividesInGuard an integer is divided by zero in its guard
 * @param dividesInEffect an integer is, in what it sends and assigns
 * @param leavesRange an integer that it sends or assigns is none of the type there
 */
public record Preconditions(
        Expression enabled,
        List<Expression> negations,
        Expression enabledButForSilence,
        Expression wrapsInGuard,
        Expression wrapsInEffect,
        Expression dividesInGuard,
        Expression dividesInEffect,
        Expression leavesRange) {
    public Preconditions {
        negations = List.copyOf(negations);
    }

    /** One per transition. */
    public static List<Preconditions> of(Component.Profile profile, Automaton automaton) {
        Guards guards = new Guards(profile);
        Negations negations = new Negations(profile, automaton, guards);
        return automaton.transitions().stream()
                .map(each -> of(guards, automaton, each, negations.of(each)))
                .toList();
    }

    private static Preconditions of(
            Guards guards,
            Automaton automaton,
            Automaton.Transition transition,
            List<Expression> negations) {
        Expression enabled = guards.enabledWhen(automaton, transition);
        List<Expression> effects = effects(transition);
        return new Preconditions(
                enabled,
                negations,
                guards.enabledButForSilence(automaton, transition, negations),
                Wraparound.HAZARD.in(enabled),
                Wraparound.HAZARD.inAny(effects),
                Hazard.DIVISION_BY_ZERO.in(enabled),
                Hazard.DIVISION_BY_ZERO.inAny(effects),
                leavesRange(transition));
    }

    private static Expression leavesRange(Automaton.Transition transition) {
        List<Expression> any = new ArrayList<>();
        for (Automaton.Send send : transition.sends()) {
            send.emission()
                    .values()
                    .forEach(value -> any.add(Hazard.outside(value, send.port().type())));
        }
        for (Automaton.Assignment assignment : transition.assignments()) {
            any.add(Hazard.outside(assignment.value(), assignment.variable().type()));
        }
        return any.stream().reduce(Hazard.NEVER, Hazard::or);
    }

    /** What a transition sends and assigns. */
    private static List<Expression> effects(Automaton.Transition transition) {
        List<Expression> all = new ArrayList<>();
        transition.sends().forEach(send -> all.addAll(send.emission().values()));
        transition.assignments().forEach(assignment -> all.add(assignment.value()));
        return all;
    }

    /** Whether an integer may wrap around at all, as far as types tell. */
    public boolean mayWrap() {
        return !Hazard.isNever(wrapsInGuard) || !Hazard.isNever(wrapsInEffect);
    }
}
