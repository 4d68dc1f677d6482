package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Region;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Whether some configuration of a state may be reached in which no known plan is possible.
 *
 * @param <T> formulas of the solver
 */
final class StateQuestion<T> {
    private final Subject subject;
    private final Logic<T> logic;
    private final SymbolicTransitions<T> here;

    /**
     * A plan, as far as the configuration decides whether it is possible.
     *
     * @param silent latched ports that must not have had a message
     */
    record Possibility(Expression condition, Set<Port> silent) {}

    StateQuestion(Subject subject, Logic<T> logic) {
        this.subject = subject;
        this.logic = logic;
        this.here = new SymbolicTransitions<>(subject, logic, logic.instant());
        logic.claim(here.instant().isWellTyped());
    }

    /**
     * @param known holds in the state
     * @param traps are not asked about
     * @param example told of a configuration, if there is one
     */
    Logic.Answer hasOther(
            int state,
            List<Expression> known,
            Collection<Region> traps,
            Collection<Possibility> plans,
            Consumer<Spot> example) {
        List<T> assumed = new ArrayList<>();
        assumed.add(here.instant().isIn(state));
        known.forEach(each -> assumed.add(here.holds(each)));
        traps.forEach(each -> assumed.add(logic.not(each.at(state, here, logic))));
        plans.forEach(each -> assumed.add(logic.not(isPossible(each))));
        return logic.assuming(assumed, () -> example.accept(Spot.of(here, subject)));
    }

    private T isPossible(Possibility plan) {
        List<T> all = new ArrayList<>();
        all.add(here.holds(plan.condition()));
        plan.silent().forEach(port -> all.add(logic.not(here.isLatched(port))));
        return logic.and(all);
    }

    boolean isExact() {
        return logic.isExact();
    }
}
