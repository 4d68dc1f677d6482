package arcomat.analysis.smt;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.semantics.expression.Guards;

import java.util.ArrayList;
import java.util.List;

/**
 * When something is so of a transition out of the present state.
 *
 * @param enabled it may be taken
 * @param wrapsInGuard an integer of its guard wraps around
 * @param wrapsInEffect an integer of what it sends and assigns does
 */
public record Condition(Expression enabled, Expression wrapsInGuard, Expression wrapsInEffect) {

    /** One per transition. */
    public static List<Condition> of(Component.Profile profile, Automaton automaton) {
        Guards guards = new Guards(profile);
        return automaton.transitions().stream().map(each -> of(guards, each)).toList();
    }

    private static Condition of(Guards guards, Automaton.Transition transition) {
        Expression enabled = guards.enabledWhen(transition);
        return new Condition(
                enabled,
                Wraparound.in(enabled),
                effects(transition).stream()
                        .map(Wraparound::in)
                        .reduce(Wraparound.NEVER, Wraparound::or));
    }

    /** What a transition sends and assigns. */
    static List<Expression> effects(Automaton.Transition transition) {
        List<Expression> all = new ArrayList<>();
        for (Automaton.Send send : transition.sends()) {
            if (send.emission() instanceof Automaton.Messages messages) {
                all.addAll(messages.values());
            }
        }
        transition.assignments().forEach(assignment -> all.add(assignment.value()));
        return all;
    }

    /** Whether an integer may wrap around at all, as far as types tell. */
    public boolean mayWrap() {
        return !Wraparound.isNever(wrapsInGuard) || !Wraparound.isNever(wrapsInEffect);
    }
}
