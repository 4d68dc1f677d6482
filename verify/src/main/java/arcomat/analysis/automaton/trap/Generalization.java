package arcomat.analysis.automaton.trap;

import arcomat.analysis.automaton.induction.Isolation;
import arcomat.analysis.automaton.trap.EscapePlan.Step;
import arcomat.model.Expression;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.expression.Replacement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * From a plan for one configuration to plans for many: what is read in it may be another term as
 * well (counterexample-guided instantiation: Reynolds, Deters, Kuncak, Tinelli, Barrett,
 * <i>Counterexample-guided quantifier instantiation for synthesis in SMT</i>, CAV 2015). A term is
 * one that the guard compares the message with, a variable, or an end of the type.
 *
 * @param inputs of the component
 * @param variables of the automaton
 */
record Generalization(List<Port> inputs, List<Variable> variables) {
    private static final int MOST = 64;

    /** How a message is chosen. */
    private enum Choice {
        TERM,
        ABOVE_TERM,
        BELOW_TERM,
        LEAST,
        MOST
    }

    /** The plan itself first. */
    List<EscapePlan> of(EscapePlan plan) {
        Set<EscapePlan> all = new LinkedHashSet<>();
        all.add(plan);
        for (Choice choice : Choice.values()) {
            all.add(everywhere(choice, plan));
        }
        for (int step = 0; step < plan.steps().size(); step++) {
            for (int port = 0; port < inputs.size(); port++) {
                for (Expression other : others(plan.steps().get(step), port)) {
                    all.add(with(other, step, port, plan));
                }
            }
        }
        return all.stream().limit(MOST).toList();
    }

    private EscapePlan everywhere(Choice choice, EscapePlan plan) {
        List<Step> steps = new ArrayList<>();
        for (Step step : plan.steps()) {
            List<Optional<Expression>> letter = new ArrayList<>();
            for (int port = 0; port < inputs.size(); port++) {
                Optional<Expression> message = step.letter().get(port);
                letter.add(
                        message.isPresent()
                                ? chosen(choice, step, port).or(() -> message)
                                : message);
            }
            steps.add(new Step(step.move(), letter));
        }
        return new EscapePlan(steps, plan.goal());
    }

    private Optional<Expression> chosen(Choice choice, Step step, int port) {
        List<Expression> terms = terms(step, port);
        return switch (choice) {
            case TERM -> terms.stream().findFirst();
            case ABOVE_TERM -> terms.stream().findFirst().flatMap(each -> beside(each, 1));
            case BELOW_TERM -> terms.stream().findFirst().flatMap(each -> beside(each, -1));
            case LEAST -> ends(inputs.get(port)).stream().findFirst();
            case MOST -> ends(inputs.get(port)).stream().skip(1).findFirst();
        };
    }

    private List<Expression> others(Step step, int port) {
        if (step.letter().get(port).isEmpty()) {
            return List.of();
        }
        List<Expression> others = new ArrayList<>();
        for (Expression term : terms(step, port)) {
            others.add(term);
            beside(term, 1).ifPresent(others::add);
            beside(term, -1).ifPresent(others::add);
        }
        others.addAll(ends(inputs.get(port)));
        return others;
    }

    private static EscapePlan with(Expression message, int step, int port, EscapePlan plan) {
        List<Step> steps = new ArrayList<>(plan.steps());
        List<Optional<Expression>> letter = new ArrayList<>(steps.get(step).letter());
        letter.set(port, Optional.of(message));
        steps.set(step, new Step(steps.get(step).move(), letter));
        return new EscapePlan(steps, plan.goal());
    }

    /** Over the variables: what is read besides is what the plan has. */
    private List<Expression> terms(Step step, int port) {
        Map<String, Optional<Expression>> others = new HashMap<>();
        for (int i = 0; i < inputs.size(); i++) {
            others.put(inputs.get(i).name(), step.letter().get(i));
        }
        others.remove(inputs.get(port).name());
        Expression asked = Replacement.ofMessages(others).of(step.move().goesOn());
        Set<Expression> terms = new LinkedHashSet<>();
        for (Expression compared : new Isolation(inputs.get(port)).terms(asked)) {
            Expression term = Replacement.ofMessages(others).of(compared);
            if (isMessage(term, inputs.get(port).type())) {
                terms.add(term);
            }
        }
        for (Variable each : variables) {
            if (PlanConditions.isAlike(each.type(), inputs.get(port).type())) {
                terms.add(new Expression.VariableRead(each, each.span()));
            }
        }
        return List.copyOf(terms);
    }

    private static boolean isMessage(Expression term, Type type) {
        return term.ports().isEmpty()
                && PlanConditions.isAlike(term.type(), type)
                && !term.divides()
                && !(term instanceof Expression.Constant constant && !type.has(constant.value()));
    }

    /** A whole number next to a term. */
    private static Optional<Expression> beside(Expression term, int distance) {
        if (!(term.type() instanceof Type.IntegerType integer)) {
            return Optional.empty();
        }
        Expression sum = Sums.beside(term, integer, distance);
        return Optional.of(Replacement.ofVariables(Map.of()).of(sum));
    }

    /** The least and the greatest number of a type; of others nothing. */
    private static List<Expression> ends(Port port) {
        if (port.type() instanceof Type.IntegerType integer) {
            return List.of(
                    constant(new Value.IntegerValue(integer.low()), port),
                    constant(new Value.IntegerValue(integer.high()), port));
        }
        return port.type() instanceof Type.RealType
                ? List.of(
                        constant(new Value.RealValue(Double.NEGATIVE_INFINITY), port),
                        constant(new Value.RealValue(Double.POSITIVE_INFINITY), port))
                : List.of();
    }

    private static Expression constant(Value value, Port port) {
        return new Expression.Constant(value, port.type(), port.span());
    }
}
