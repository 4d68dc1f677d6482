package arcomat.analysis.smt;

import arcomat.analysis.reachability.Hazard;
import arcomat.analysis.reachability.Preconditions;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.StepRelation;
import arcomat.semantics.expression.Formulas;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.UnaryOperator;

/**
 * A step that may be possible in a configuration, as far as messages have a say in it. All
 * expressions read ports only.
 *
 * @param asks conditions that decide whether it is possible, and whether it goes wrong; of a
 *     transition: its guard goes wrong, it may be taken, it does not go wrong then, it happens
 * @param happens that it is possible and goes well
 * @param sends what, by the name of the output port; ports on which nothing is sent that depends on
 *     the step are left out
 * @param stores what the configuration after it remembers
 */
public record DataStep(
        List<Expression> asks,
        Expression happens,
        Map<String, List<Expression>> sends,
        List<Expression> stores) {
    public DataStep {
        asks = List.copyOf(asks);
        sends = Map.copyOf(sends);
        stores = List.copyOf(stores);
    }

    /**
     * The transitions of an automaton that lead out of a configuration.
     *
     * @param preconditions one per transition
     */
    public static List<DataStep> outOf(
            Configuration configuration, StepRelation relation, List<Preconditions> preconditions) {
        List<DataStep> steps = new ArrayList<>();
        List<Automaton.Transition> transitions = relation.automaton().transitions();
        for (int i = 0; i < transitions.size() && configuration.isState(); i++) {
            if (transitions.get(i).source() == configuration.state()) {
                steps.add(of(transitions.get(i), preconditions.get(i), configuration, relation));
            }
        }
        return steps;
    }

    private static DataStep of(
            Automaton.Transition transition,
            Preconditions when,
            Configuration configuration,
            StepRelation relation) {
        Map<String, List<Expression>> sends = new HashMap<>();
        List<Expression> stores = new ArrayList<>();
        Map<String, Expression> variables = new HashMap<>();
        for (Automaton.Send send : transition.sends()) {
            List<Expression> values = new ArrayList<>();
            for (Expression value : send.emission().values()) {
                values.add(relation.reduced(value, configuration));
            }
            sends.put(send.port().name(), values);
        }
        for (Automaton.Assignment assignment : transition.assignments()) {
            Expression value = relation.reduced(assignment.value(), configuration);
            stores.add(value);
            variables.put(assignment.variable().name(), value);
        }
        shown(relation, configuration, variables, sends);
        Expression divides = when.dividesInGuard();
        Expression enabled = Hazard.isNever(divides) ? when.enabled() : and(not(divides), when);
        Expression dividesThen = when.dividesInEffect();
        Expression goesOn =
                Hazard.isNever(dividesThen)
                        ? enabled
                        : Hazard.and(enabled, Hazard.not(dividesThen));
        Expression leaves = when.leavesRange();
        Expression happens =
                Hazard.isNever(leaves) ? goesOn : Hazard.and(goesOn, Hazard.not(leaves));
        List<Expression> asks = new ArrayList<>(List.of(divides, enabled, goesOn, happens));
        asks.replaceAll(each -> relation.reduced(each, configuration));
        return new DataStep(asks, asks.get(3), sends, stores);
    }

    private static Expression not(Expression e) {
        return Hazard.not(e);
    }

    private static Expression and(Expression first, Preconditions when) {
        return Hazard.and(first, when.enabled());
    }

    /** Variables that ports show have their values after the step. */
    private static void shown(
            StepRelation relation,
            Configuration configuration,
            Map<String, Expression> assigned,
            Map<String, List<Expression>> sends) {
        if (relation.component().body() instanceof Component.Atomic atomic) {
            for (Component.Shown shown : atomic.shown()) {
                relation.automaton().variables().stream()
                        .filter(variable -> variable.name().equals(shown.variable()))
                        .map(
                                variable ->
                                        assigned.getOrDefault(
                                                variable.name(),
                                                relation.reduced(
                                                        new Expression.VariableRead(
                                                                variable, variable.span()),
                                                        configuration)))
                        .forEach(value -> sends.put(shown.port(), List.of(value)));
            }
        }
    }

    /** What ports show of variables while nothing changes, by the name of the port. */
    public static Map<String, Expression> shown(
            StepRelation relation, Configuration configuration) {
        Map<String, List<Expression>> sends = new HashMap<>();
        shown(relation, configuration, Map.of(), sends);
        Map<String, Expression> values = new HashMap<>();
        sends.forEach((port, value) -> values.put(port, value.get(0)));
        return values;
    }

    /**
     * What is seen whatever the step is.
     *
     * @param messages per port
     */
    public static DataStep sending(List<Port> ports, List<List<Value>> messages) {
        Map<String, List<Expression>> sends = new HashMap<>();
        for (int i = 0; i < ports.size(); i++) {
            Port port = ports.get(i);
            sends.put(
                    port.name(),
                    messages.get(i).stream()
                            .<Expression>map(
                                    value ->
                                            new Expression.Constant(
                                                    value, port.type(), port.span()))
                            .toList());
        }
        return new DataStep(List.of(), Hazard.not(Hazard.NEVER), sends, List.of());
    }

    /**
     * That the guard of a transition lets it be taken, or goes wrong: then nothing is completed.
     */
    public Expression tried() {
        return Formulas.or(asks.get(0), asks.get(1));
    }

    /** A transition with other conditions. */
    public DataStep asked(UnaryOperator<Expression> rest) {
        List<Expression> others = asks.stream().map(rest).toList();
        return new DataStep(others, others.get(3), sends, stores);
    }

    /** The same, but what is sent on some ports is remembered until it is compared. */
    public DataStep remembering(List<Port> ports) {
        Map<String, List<Expression>> others = new LinkedHashMap<>(sends);
        List<Expression> remembered = new ArrayList<>(stores);
        for (Port port : ports) {
            if (others.containsKey(port.name())) {
                remembered.addAll(Objects.requireNonNull(others.remove(port.name())));
            }
        }
        return new DataStep(asks, happens, others, remembered);
    }

    /** What decides about some steps together. */
    static List<DataFact> facts(List<DataStep> steps) {
        List<DataFact> facts = new ArrayList<>();
        for (int i = 0; i < steps.size(); i++) {
            DataStep step = steps.get(i);
            step.asks.forEach(ask -> facts.add(new DataFact.Holds(ask)));
            step.stores.forEach(value -> facts.add(new DataFact.Stored(step.happens, value)));
            for (DataStep other : steps.subList(i + 1, steps.size())) {
                addSame(step, other, facts);
            }
        }
        return facts;
    }

    private static void addSame(DataStep one, DataStep two, List<DataFact> facts) {
        Expression both = Hazard.and(one.happens, two.happens);
        one.sends.forEach(
                (port, values) -> {
                    List<Expression> others = two.sends.getOrDefault(port, List.of());
                    for (int i = 0; i < values.size() && values.size() == others.size(); i++) {
                        facts.add(new DataFact.Same(both, values.get(i), others.get(i)));
                    }
                });
    }
}
