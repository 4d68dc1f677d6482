package arcomat.generate;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Variable;
import arcomat.semantics.network.Composition;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The enums and classes that the code of a component mentions, in the order of first mention. */
final class MentionedTypes {
    private final Map<String, Type> found = new LinkedHashMap<>();

    static List<Type> of(Component component, Optional<Composition> composition) {
        MentionedTypes types = new MentionedTypes();
        component.ports().forEach(p -> types.add(p.type()));
        component.parameters().forEach(p -> types.add(p.type()));
        component.constants().forEach(types::add);
        Members.automaton(component).ifPresent(types::add);
        composition.ifPresent(c -> c.nodes().forEach(n -> n.arguments().forEach(types::add)));
        return new ArrayList<>(types.found.values());
    }

    /** Those that the attributes of a class mention. */
    static List<Type> of(Type.ClassType type) {
        MentionedTypes types = new MentionedTypes();
        type.attributes().forEach(a -> types.add(a.type()));
        return new ArrayList<>(types.found.values());
    }

    private void add(Type type) {
        if (type instanceof Type.EnumType || type instanceof Type.ClassType) {
            found.putIfAbsent(type.name(), type);
        }
    }

    private void add(Variable variable) {
        add(variable.type());
        add(variable.initial());
    }

    private void add(Automaton automaton) {
        automaton.variables().forEach(this::add);
        for (Automaton.Initial initial : automaton.initials()) {
            initial.sends().forEach(this::add);
            initial.assignments().forEach(a -> add(a.value()));
        }
        for (Automaton.Transition transition : automaton.transitions()) {
            transition.matches().forEach(m -> add(m.pattern()));
            transition.guard().ifPresent(this::add);
            transition.sends().forEach(this::add);
            transition.assignments().forEach(a -> add(a.value()));
        }
    }

    private void add(Automaton.Pattern pattern) {
        if (pattern instanceof Automaton.OneOf oneOf) {
            oneOf.values().forEach(this::add);
        }
    }

    private void add(Automaton.Send send) {
        if (send.emission() instanceof Automaton.Messages messages) {
            messages.values().forEach(this::add);
        }
    }

    private void add(Expression expression) {
        expression.visit(
                e -> {
                    add(e.type());
                    if (e instanceof Expression.PortMatches matches) {
                        add(matches.port().type());
                    }
                });
    }
}
