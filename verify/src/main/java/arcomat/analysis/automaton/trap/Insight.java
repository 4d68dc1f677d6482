package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Region;
import arcomat.analysis.reachability.StateFacts;
import arcomat.analysis.reachability.Subject;
import arcomat.model.Expression;
import arcomat.model.ExpressionText;
import arcomat.model.Port;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** What has been found out about one automaton so far, by whichever solver. */
final class Insight {
    private final Subject subject;
    private final Map<Integer, Map<String, EscapePlan>> plans = new TreeMap<>();

    /** What holds in each state that may be reached. */
    private StateFacts facts;

    /** Something can be sent from there on, but for the traps. */
    final Set<Integer> settled = new TreeSet<>();

    final List<Region> traps = new ArrayList<>();

    /** Where neither is known, by state. */
    final Map<Integer, Spot> stuck = new LinkedHashMap<>();

    Insight(Subject subject, Set<Integer> states) {
        this.subject = subject;
        facts =
                new StateFacts(
                        states.stream().collect(Collectors.toMap(each -> each, each -> List.of())));
    }

    /** The states about which it is open whether something can be sent. */
    Set<Integer> open() {
        Set<Integer> open = new TreeSet<>(facts.byState().keySet());
        open.removeAll(settled);
        return open;
    }

    /** Those that begin in a state. */
    Collection<EscapePlan> plans(int state) {
        return plans.getOrDefault(state, Map.of()).values();
    }

    /** One of several that are possible under the same condition is enough. */
    void plan(EscapePlan plan, Expression condition) {
        String kind = plan.goal() + " " + silent(plan) + ExpressionText.of(condition);
        plans.computeIfAbsent(plan.source(), each -> new LinkedHashMap<>()).putIfAbsent(kind, plan);
    }

    StateFacts facts() {
        return facts;
    }

    /** What else holds in each state. */
    void learn(StateFacts more) {
        facts = facts.and(more);
    }

    /** The latched ports that have no message in some step of a plan. */
    Set<Port> silent(EscapePlan plan) {
        List<Port> inputs = subject.component().inputs();
        return subject.latchable().stream()
                .filter(
                        port ->
                                plan.steps().stream()
                                        .anyMatch(
                                                each ->
                                                        each.letter()
                                                                .get(inputs.indexOf(port))
                                                                .isEmpty()))
                .collect(Collectors.toSet());
    }
}
