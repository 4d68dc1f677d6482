package arcomat.generate.text;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Type;
import arcomat.model.Value;
import arcomat.model.Variable;
import arcomat.semantics.network.Composition;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** The enums and classes that the code of a component mentions, in the order of first mention. */
public final class MentionedTypes {
    private final Map<String, Type> found = new LinkedHashMap<>();

    private MentionedTypes() {}

    public static List<Type> of(Component component, Optional<Composition> composition) {
        MentionedTypes types = new MentionedTypes();
        component.ports().forEach(p -> types.add(p.type()));
        component.parameters().forEach(p -> types.add(p.type()));
        component.constants().forEach(types::add);
        MemberNames.automaton(component).ifPresent(types::add);
        composition.ifPresent(c -> c.nodes().forEach(n -> n.arguments().forEach(types::add)));
        return List.copyOf(types.found.values());
    }

    /** Those that the attributes of a class mention. */
    public static List<Type> of(Type.ClassType type) {
        MentionedTypes types = new MentionedTypes();
        type.attributes().forEach(a -> types.add(a.type()));
        return List.copyOf(types.found.values());
    }

    private void add(Type type) {
        if (type instanceof Type.EnumType || type instanceof Type.ClassType) {
            found.putIfAbsent(type.name(), type);
            arguments(type).forEach(this::add);
        }
    }

    /** An object is written with all that it is made of. */
    private void add(Value value) {
        if (value instanceof Value.ObjectValue object) {
            add(object.type());
            object.attributes().forEach(this::add);
        } else if (value instanceof Value.EnumValue constant) {
            add(constant.type());
        }
    }

    /** The types that messages of a class of Java may hold. */
    private static Stream<Type> arguments(Type type) {
        return type instanceof Type.ClassType object
                ? object.java().stream()
                        .flatMap(java -> java.arguments().stream())
                        .flatMap(argument -> argument.type().stream())
                : Stream.empty();
    }

    private void add(Variable variable) {
        add(variable.type());
        add(variable.initial());
    }

    private void add(Automaton automaton) {
        automaton.variables().forEach(this::add);
        automaton.initials().stream().flatMap(WrittenExpressions::of).forEach(this::add);
        automaton.transitions().stream().flatMap(WrittenExpressions::of).forEach(this::add);
        automaton.transitions().stream()
                .flatMap(each -> each.body().stream())
                .distinct()
                .flatMap(body -> body.statement().expressions().stream())
                .forEach(this::add);
    }

    private void add(Expression expression) {
        expression.visit(
                e -> {
                    add(e.type());
                    if (e instanceof Expression.Constant constant) {
                        add(constant.value());
                    }
                    if (e instanceof Expression.PortMatches matches) {
                        add(matches.port().type());
                    }
                });
    }
}
