package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Move;
import arcomat.model.Expression;

import java.util.List;
import java.util.Optional;

/**
 * How something may come to be sent: transitions, one after the other, each with what is read then.
 *
 * @param steps at least one
 * @param goal what the last one does
 */
record EscapePlan(List<Step> steps, Goal goal) {
    EscapePlan {
        steps = List.copyOf(steps);
    }

    /**
     * A transition on a letter.
     *
     * @param letter by position of the input port, over the variables before; empty for silence
     */
    record Step(Move move, List<Optional<Expression>> letter) {
        Step {
            letter = List.copyOf(letter);
        }
    }

    /** What a plan is good for. */
    enum Goal {
        /** Its last transition sends, or goes wrong. */
        ESCAPES,
        /** It leads to where it is known already that something can be sent. */
        SETTLES,
        /** It comes closer to that. */
        PROGRESSES
    }

    /** The state that it begins in. */
    int source() {
        return steps.get(0).move().source();
    }

    /** Where it leads, if it goes on from there. */
    int target() {
        return steps.get(steps.size() - 1).move().target();
    }
}
