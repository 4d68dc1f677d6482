package arcomat.lower;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Variable;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * One way through statements, up to some place. All that it has is said of the values before the
 * first of them.
 *
 * @param conditions that are true where this way is gone, first to last
 * @param values what variables stand for, in the order of their first assignment
 * @param sends what ports carry, by their names, in the order of their first message
 */
record ActionPath(
        List<Expression> conditions,
        Map<Variable, Expression> values,
        Map<String, Automaton.Send> sends) {
    static final ActionPath EMPTY = new ActionPath(List.of(), Map.of(), Map.of());

    /** The value of an expression at this place. */
    Expression current(Expression expression) {
        if (expression instanceof Expression.VariableRead read) {
            return values.getOrDefault(read.variable(), read);
        }
        return values.isEmpty() ? expression : expression.withOperands(this::current);
    }

    /** What is assigned last counts. */
    ActionPath assigning(Variable variable, Expression value) {
        Map<Variable, Expression> more = new LinkedHashMap<>(values);
        more.put(variable, current(value));
        return new ActionPath(conditions, more, sends);
    }

    /** What is sent last counts. */
    ActionPath sending(Automaton.Send send) {
        Map<String, Automaton.Send> more = new LinkedHashMap<>(sends);
        more.put(send.port().name(), new Automaton.Send(send.port(), current(send.emission())));
        return new ActionPath(conditions, values, more);
    }

    private Automaton.Emission current(Automaton.Emission emission) {
        return emission.match(
                messages ->
                        new Automaton.Messages(
                                messages.values().stream().map(this::current).toList()),
                () -> emission,
                () -> emission);
    }

    /** The same with its values in the order in which the text assigns them, on whichever way. */
    ActionPath inOrder(List<String> names) {
        Map<Variable, Expression> ordered = new LinkedHashMap<>();
        values.keySet().stream()
                .sorted(Comparator.comparingInt(each -> names.indexOf(each.name())))
                .forEach(each -> ordered.put(each, Objects.requireNonNull(values.get(each))));
        return new ActionPath(conditions, ordered, sends);
    }

    /** All that it asks, assigns and sends. */
    List<Expression> expressions() {
        List<Expression> all = new ArrayList<>(conditions);
        all.addAll(values.values());
        sends.values().forEach(send -> all.addAll(send.emission().values()));
        return all;
    }

    List<Automaton.Assignment> assignments() {
        return values.entrySet().stream()
                .map(each -> new Automaton.Assignment(each.getKey(), each.getValue()))
                .toList();
    }

    List<Automaton.Send> sent() {
        return List.copyOf(sends.values());
    }
}
