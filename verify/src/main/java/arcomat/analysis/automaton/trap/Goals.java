package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Region;
import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.semantics.expression.Formulas;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Where it is enough to come to, if not to where something is sent at once: from there on it is
 * known that something can be sent.
 *
 * @param settled states from which something can be sent, but from the traps in them
 * @param measure what makes progress within some other states, if it is looked for
 * @param closer these states
 * @param traps from there nothing is sent
 */
record Goals(
        Set<Integer> settled,
        Optional<RankingFunction> measure,
        Set<Integer> closer,
        List<Region> traps) {
    Goals {
        settled = new TreeSet<>(settled);
        closer = new TreeSet<>(closer);
        traps = List.copyOf(traps);
    }

    /** What has to be so at the end of a plan, over the variables there. */
    Expression atEnd(int state) {
        return traps.stream()
                .map(each -> Formulas.not(each.in(state)))
                .reduce(Formulas.TRUE, Formulas::and);
    }

    /** What has to be so before a plan that leads to one of them; empty where none is known. */
    Optional<Expression> condition(EscapePlan plan, PlanConditions conditions) {
        int state = plan.target();
        return switch (plan.goal()) {
            case ESCAPES -> conditions.of(plan, Formulas.TRUE);
            case SETTLES ->
                    settled.contains(state) ? conditions.of(plan, atEnd(state)) : Optional.empty();
            case PROGRESSES ->
                    closer.contains(state)
                            ? measure.flatMap(each -> closer(each, plan, conditions))
                            : Optional.empty();
        };
    }

    private Optional<Expression> closer(
            RankingFunction each, EscapePlan plan, PlanConditions conditions) {
        return conditions
                .before(plan, each.value())
                .flatMap(
                        later ->
                                conditions
                                        .of(plan, atEnd(plan.target()))
                                        .map(
                                                possible ->
                                                        Formulas.and(
                                                                possible,
                                                                each.isCloser(
                                                                        later, each.value()))));
    }

    /** That a point of a run is one, and what is measured is beyond what it was. */
    <T> T at(SymbolicTransitions<T> there, Optional<Expression> measured, Logic<T> logic) {
        List<T> any = new ArrayList<>();
        settled.forEach(state -> any.add(isFree(state, there, logic)));
        if (measure.isPresent() && measured.isPresent()) {
            Expression isCloser = measure.get().isCloser(measure.get().value(), measured.get());
            T nearer = there.holds(isCloser);
            closer.forEach(
                    state -> any.add(logic.and(List.of(isFree(state, there, logic), nearer))));
        }
        return logic.or(any);
    }

    private <T> T isFree(int state, SymbolicTransitions<T> there, Logic<T> logic) {
        return logic.and(List.of(there.instant().isIn(state), there.holds(atEnd(state))));
    }
}
