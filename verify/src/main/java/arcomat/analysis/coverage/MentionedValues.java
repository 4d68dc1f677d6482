package arcomat.analysis.coverage;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** The values and the ports that transitions mention. */
final class MentionedValues {
    private final Set<Value> values = new LinkedHashSet<>();
    private final Set<String> ports = new LinkedHashSet<>();

    private MentionedValues() {}

    /** Those of a component with arguments. */
    static MentionedValues of(Component component, List<Value> arguments) {
        MentionedValues mentions = new MentionedValues();
        mentions.values.addAll(arguments);
        component.constants().forEach(constant -> mentions.add(constant.initial()));
        for (Automaton automaton : component.automata()) {
            automaton.transitions().forEach(mentions::add);
        }
        return mentions;
    }

    static MentionedValues of(Automaton.Transition transition) {
        MentionedValues mentions = new MentionedValues();
        mentions.add(transition);
        return mentions;
    }

    private void add(Automaton.Transition transition) {
        transition.guard().ifPresent(this::add);
        for (Automaton.Match match : transition.matches()) {
            ports.add(match.port().name());
            match.pattern().values().forEach(this::add);
        }
        for (Automaton.Send send : transition.sends()) {
            send.emission().values().forEach(this::add);
        }
        transition.assignments().forEach(assignment -> add(assignment.value()));
    }

    private void add(Expression expression) {
        expression.visit(
                e -> {
                    if (e instanceof Expression.Constant constant) {
                        values.add(constant.value());
                    }
                });
        expression.ports().forEach(port -> ports.add(port.name()));
    }

    boolean port(String name) {
        return ports.contains(name);
    }

    /** The mentioned values of a type with many values; of none that are objects. */
    List<Value> of(Type type) {
        return values.stream().filter(value -> isOf(value, type)).toList();
    }

    private static boolean isOf(Value value, Type type) {
        return type instanceof Type.IntegerType range
                ? value instanceof Value.IntegerValue number
                        && range.low() <= number.value()
                        && number.value() <= range.high()
                : !(type instanceof Type.ClassType) && value.getClass() == type.first().getClass();
    }
}
