package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.source.Span;

import java.util.ArrayList;
import java.util.List;

/** What a transition asks for, by its guard and its input block, in the order of the text. */
final class TransitionCondition {
    private final List<Automaton.Match> matches = new ArrayList<>();
    private final List<Expression> guards = new ArrayList<>();
    private final List<InputCondition> inputs = new ArrayList<>();
    private final List<Expression> all = new ArrayList<>();

    void add(Expression condition) {
        guards.add(condition);
        all.add(condition);
    }

    void add(InputCondition condition) {
        condition.match().ifPresentOrElse(matches::add, () -> guards.add(condition.guard()));
        inputs.add(condition);
        all.add(condition.guard());
    }

    /** What a letter has to match. */
    List<Automaton.Match> matches() {
        return List.copyOf(matches);
    }

    /** What matches cannot say. */
    List<Expression> guards() {
        return List.copyOf(guards);
    }

    /** Whether one letter may satisfy both, as far as constants tell. */
    boolean canMeet(TransitionCondition other) {
        return inputs.stream().noneMatch(c -> other.inputs.stream().anyMatch(c::excludes));
    }

    /**
     * That it is not satisfied; one that asks nothing always is.
     *
     * @param place of who says so
     */
    Expression denial(Span place) {
        return all.isEmpty()
                ? Connectives.never(place)
                : Connectives.not(Connectives.conjunction(all));
    }
}
