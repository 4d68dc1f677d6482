package arcomat.analysis.reachability;

import arcomat.analysis.reachability.Unrolling.StatePredicate;
import arcomat.model.Expression;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * What is so of the variables whenever a run is in a state.
 *
 * @param byState by index of the state; no run is in another one. Empty where nothing is known
 */
public record StateFacts(Map<Integer, List<Expression>> byState) {
    public static final StateFacts NONE = new StateFacts(Map.of());

    public StateFacts {
        Map<Integer, List<Expression>> sorted = new TreeMap<>();
        byState.forEach((state, all) -> sorted.put(state, List.copyOf(all)));
        byState = sorted;
    }

    private boolean isNone() {
        return byState.isEmpty();
    }

    /** What is so in a state. */
    public List<Expression> in(int state) {
        return byState.getOrDefault(state, List.of());
    }

    /** Both are so. */
    public StateFacts and(StateFacts more) {
        if (isNone() || more.isNone()) {
            return isNone() ? more : this;
        }
        Map<Integer, List<Expression>> both = new TreeMap<>();
        byState.forEach(
                (state, all) -> {
                    if (more.byState.containsKey(state)) {
                        Set<Expression> here = new LinkedHashSet<>(all);
                        here.addAll(more.in(state));
                        both.put(state, List.copyOf(here));
                    }
                });
        return new StateFacts(both);
    }

    /** That a configuration is none of those that runs reach. */
    public <T> StatePredicate<T> contradicted(Logic<T> logic) {
        return there -> isNone() ? logic.of(false) : logic.not(possible(there, logic));
    }

    private <T> T possible(SymbolicTransitions<T> there, Logic<T> logic) {
        List<T> possible = new ArrayList<>();
        byState.forEach(
                (state, all) -> {
                    List<T> here = new ArrayList<>();
                    here.add(there.instant().isIn(state));
                    all.forEach(each -> here.add(there.holds(each)));
                    possible.add(logic.and(here));
                });
        return logic.or(possible);
    }
}
