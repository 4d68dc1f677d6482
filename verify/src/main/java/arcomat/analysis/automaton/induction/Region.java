package arcomat.analysis.automaton.induction;

import arcomat.analysis.reachability.Logic;
import arcomat.analysis.reachability.SymbolicTransitions;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.semantics.expression.Formulas;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Configurations that no run leaves, and in which nothing is sent and nothing goes wrong: a trap,
 * if one of them is reached.
 *
 * @param conditions of each of its states, by index: all hold there, over the variables
 * @param latched the ports that have had a message
 */
public record Region(Map<Integer, List<Expression>> conditions, Set<Port> latched) {
    public Region {
        Map<Integer, List<Expression>> sorted = new TreeMap<>();
        conditions.forEach((state, each) -> sorted.put(state, List.copyOf(each)));
        conditions = sorted;
        latched = Set.copyOf(latched);
    }

    /** What has to be so in a state; that some ports have had a message is left aside. */
    public Expression in(int state) {
        List<Expression> all = conditions.get(state);
        return all == null ? Formulas.FALSE : all.stream().reduce(Formulas.TRUE, Formulas::and);
    }

    /** Whether the configuration at a point of a run is one of them. */
    public <T> T at(SymbolicTransitions<T> there, Logic<T> logic) {
        return logic.or(
                conditions.keySet().stream().map(state -> at(state, there, logic)).toList());
    }

    /** Whether it is one in a state. */
    public <T> T at(int state, SymbolicTransitions<T> there, Logic<T> logic) {
        List<Expression> all = conditions.get(state);
        if (all == null) {
            return logic.of(false);
        }
        List<T> here = new ArrayList<>();
        here.add(there.instant().isIn(state));
        all.forEach(each -> here.add(there.holds(each)));
        latched.forEach(port -> here.add(there.isLatched(port)));
        return logic.and(here);
    }

    /** A larger one: without a condition in a state. */
    public Region without(Expression condition, int state) {
        Map<Integer, List<Expression>> fewer = new TreeMap<>(conditions);
        fewer.computeIfPresent(
                state, (each, all) -> all.stream().filter(one -> one != condition).toList());
        return new Region(fewer, latched);
    }

    /** The same configurations, whichever ports have had a message. */
    public Region withoutLatched() {
        return new Region(conditions, Set.of());
    }

    /** Whether two have a state in common. */
    public boolean meets(Region other) {
        return conditions.keySet().stream().anyMatch(other.conditions::containsKey);
    }
}
