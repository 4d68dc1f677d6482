package arcomat.generate;

import arcomat.generate.text.WrittenExpressions;
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
import java.util.stream.Stream;

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
            Type type = port.type();
            if (isOfModel(type)) {
                qualified
                        .computeIfAbsent(type.simpleName(), name -> new TreeSet<>())
                        .add(type.name());
            }
        }
    }

    private static boolean isOfModel(Type type) {
        return type instanceof Type.EnumType
                || type instanceof Type.ClassType object && object.java().isEmpty();
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
        boolean clear = qualified.getOrDefault(type.simpleName(), Set.of()).size() == 1;
        return clear ? type.simpleName() : type.name();
    }

    /** What a transition sends. */
    String message(Automaton.Send send) {
        List<Expression> values = send.emission().values();
        String all = constants(values);
        return send.port().name() + " = " + (values.size() == 1 ? all : "[" + all + "]");
    }

    private String constant(Expression expression) {
        Expression.Constant constant = (Expression.Constant) expression;
        Value value = constant.value();
        return value instanceof Value.EnumValue && ports.contains(value.toString())
                ? type(constant.type()) + "." + value
                : literal(value, constant.type());
    }

    private static String literal(Value value, Type type) {
        if (value instanceof Value.IntegerValue number && number.value() != (int) number.value()) {
            return value + "L";
        }
        if (value instanceof Value.RealValue real && !Double.isFinite(real.value())) {
            // These have no literal.
            return "(" + (Double.isNaN(real.value()) ? 0.0 : Math.signum(real.value())) + " / 0.0)";
        }
        boolean single = type instanceof Type.RealType real && real.single();
        return single ? (float) ((Value.RealValue) value).value() + "f" : value.toString();
    }

    /** An item of an input block: a port carries what one of the patterns says. */
    record Item(Port port, String text) {}

    Item item(Port port, List<Automaton.Pattern> patterns) {
        List<String> alternatives =
                patterns.stream()
                        .flatMap(
                                pattern ->
                                        pattern.match(
                                                oneOf ->
                                                        oneOf.values().stream().map(this::constant),
                                                () -> Stream.of("--"),
                                                () -> Stream.of("?")))
                        .toList();
        String all = String.join(", ", alternatives);
        String said = alternatives.size() == 1 ? all : "alt {" + all + "}";
        return new Item(port, port.name() + " == " + said);
    }

    /** A disjunction of nothing but patterns of one port as an item; empty for another guard. */
    Optional<Item> item(Expression guard) {
        List<Automaton.Pattern> patterns = new ArrayList<>();
        Set<Port> matched = new HashSet<>();
        for (Expression part : WrittenExpressions.row(guard, BinaryOperator.OR)) {
            if (!(part instanceof Expression.PortMatches matches)) {
                return Optional.empty();
            }
            matched.add(matches.port());
            patterns.add(matches.pattern());
        }
        return matched.stream()
                .filter(port -> matched.size() == 1)
                .map(port -> item(port, patterns))
                .findFirst();
    }

    String conjunction(List<Expression> guards) {
        return guards.stream()
                .map(
                        guard ->
                                guards.size() > 1
                                                && WrittenExpressions.row(guard, BinaryOperator.OR)
                                                                .size()
                                                        > 1
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
        return switch (binary.operator()) {
            case OR ->
                    WrittenExpressions.row(binary, BinaryOperator.OR).stream()
                            .map(this::guard)
                            .collect(Collectors.joining(" || "));
            case AND -> conjunction(WrittenExpressions.row(binary, BinaryOperator.AND));
            default ->
                    ((Expression.PortRead) binary.left()).port().name()
                            + (" " + binary.operator().sign() + " ")
                            + operand(binary.right());
        };
    }

    private String operand(Expression e) {
        return e instanceof Expression.PortRead read ? read.port().name() : constant(e);
    }

    private String matches(Expression.PortMatches matches) {
        String asked =
                matches.pattern()
                        .match(
                                oneOf -> " isin {" + constants(oneOf.values()) + "}",
                                () -> " == --",
                                () -> " != --");
        return matches.port().name() + asked;
    }

    private String constants(List<Expression> values) {
        return values.stream().map(this::constant).collect(Collectors.joining(", "));
    }
}
