package arcomat.generate;

import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * Types, messages and conditions as a model writes them, with short names where these are clear.
 */
final class ModelWords {
    private final Map<String, Set<String>> qualified = new TreeMap<>();
    private final Set<String> ports;

    /**
     * @param component whose ports have the types
     */
    ModelWords(Component component) {
        ports = component.ports().stream().map(Port::name).collect(Collectors.toSet());
        for (Port port : component.ports()) {
            simpleName(port.type())
                    .ifPresent(
                            name ->
                                    qualified
                                            .computeIfAbsent(name, each -> new TreeSet<>())
                                            .add(port.type().name()));
        }
    }

    private static Optional<String> simpleName(Type type) {
        if (type instanceof Type.EnumType enumeration) {
            return Optional.of(enumeration.simpleName());
        }
        return type instanceof Type.ClassType object
                ? Optional.of(object.simpleName())
                : Optional.empty();
    }

    /** What is to be imported; types of one name are written in full instead. */
    List<String> imports() {
        return qualified.values().stream()
                .filter(names -> names.size() == 1)
                .map(names -> names.iterator().next())
                .filter(name -> name.contains("."))
                .sorted()
                .toList();
    }

    String type(Type type) {
        return simpleName(type)
                .filter(name -> qualified.getOrDefault(name, Set.of()).size() == 1)
                .orElse(type.name());
    }

    /** What a transition sends on a port. */
    String message(Automaton.Send send) {
        List<String> values = new ArrayList<>();
        for (Expression value : ((Automaton.Messages) send.emission()).values()) {
            values.add(constant(value));
        }
        return values.size() == 1 ? values.get(0) : "[" + String.join(", ", values) + "]";
    }

    private String constant(Expression expression) {
        Expression.Constant constant = (Expression.Constant) expression;
        Value value = constant.value();
        if (value instanceof Value.EnumValue && ports.contains(value.toString())) {
            return type(constant.type()) + "." + value;
        }
        if (value instanceof Value.IntegerValue number && number.value() != (int) number.value()) {
            return value + "L";
        }
        if (value instanceof Value.RealValue real && !Double.isFinite(real.value())) {
            // These have no literal.
            return "(" + (Double.isNaN(real.value()) ? 0.0 : Math.signum(real.value())) + " / 0.0)";
        }
        boolean single = constant.type() instanceof Type.RealType real && real.single();
        return single
                ? (float) ((Value.RealValue) constant.value()).value() + "f"
                : value.toString();
    }

    /** An item of an input block: a port carries what one of the patterns says. */
    String item(Port port, List<Automaton.Pattern> patterns) {
        List<String> alternatives = new ArrayList<>();
        for (Automaton.Pattern pattern : patterns) {
            if (pattern instanceof Automaton.OneOf oneOf) {
                oneOf.values().forEach(value -> alternatives.add(constant(value)));
            } else {
                alternatives.add(pattern instanceof Automaton.Absent ? "--" : "?");
            }
        }
        return port.name()
                + " == "
                + (alternatives.size() == 1
                        ? alternatives.get(0)
                        : "alt {" + String.join(", ", alternatives) + "}");
    }

    /** The port that a disjunction of nothing but patterns is about. */
    static Optional<Port> soleMatch(Expression guard) {
        List<Expression> parts = new ArrayList<>();
        collect(guard, parts);
        Set<Port> matched = new HashSet<>();
        for (Expression part : parts) {
            if (!(part instanceof Expression.PortMatches matches)) {
                return Optional.empty();
            }
            matched.add(matches.port());
        }
        return matched.stream().findFirst().filter(port -> matched.size() == 1);
    }

    /** A disjunction of patterns of one port as an item. */
    String alternatives(Expression guard) {
        List<Expression> parts = new ArrayList<>();
        collect(guard, parts);
        Port port = ((Expression.PortMatches) parts.get(0)).port();
        return item(port, parts.stream().map(p -> ((Expression.PortMatches) p).pattern()).toList());
    }

    private static void collect(Expression guard, List<Expression> parts) {
        Optional<Expression.Binary> or = binary(guard, BinaryOperator.OR);
        if (or.isPresent()) {
            collect(or.get().left(), parts);
            collect(or.get().right(), parts);
        } else {
            parts.add(guard);
        }
    }

    static Optional<Expression.Binary> binary(Expression expression, BinaryOperator operator) {
        return expression instanceof Expression.Binary binary && binary.operator() == operator
                ? Optional.of(binary)
                : Optional.empty();
    }

    String conjunction(List<Expression> guards) {
        return guards.stream()
                .map(
                        guard ->
                                guards.size() > 1 && binary(guard, BinaryOperator.OR).isPresent()
                                        ? "(" + guard(guard) + ")"
                                        : guard(guard))
                .collect(Collectors.joining(" && "));
    }

    /** Conditions with few operators: "and" binds tighter than "or". */
    private String guard(Expression guard) {
        if (guard instanceof Expression.PortMatches matches) {
            return matches(matches);
        }
        if (guard instanceof Expression.Unary not) {
            return "!(" + guard(not.operand()) + ")";
        }
        Expression.Binary binary = (Expression.Binary) guard;
        if (binary.operator() == BinaryOperator.OR) {
            return guard(binary.left()) + " || " + guard(binary.right());
        }
        if (binary.operator() == BinaryOperator.AND) {
            return conjunction(List.of(binary.left(), binary.right()));
        }
        return ((Expression.PortRead) binary.left()).port().name()
                + " "
                + binary.operator().sign()
                + " "
                + operand(binary.right());
    }

    private String operand(Expression e) {
        return e instanceof Expression.PortRead read ? read.port().name() : constant(e);
    }

    private String matches(Expression.PortMatches matches) {
        String port = matches.port().name();
        if (matches.pattern() instanceof Automaton.OneOf oneOf) {
            return port
                    + " isin {"
                    + oneOf.values().stream().map(this::constant).collect(Collectors.joining(", "))
                    + "}";
        }
        return port + (matches.pattern() instanceof Automaton.Absent ? " == --" : " != --");
    }
}
