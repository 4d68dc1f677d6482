package arcomat.symbols.expressions;

import arcomat.symbols.expressions.ExpressionProblem.Kind;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.JavaType;
import arcomat.symbols.names.OpaqueSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;

/**
 * What can be written in stream tests only. Objects, with one value per attribute, inherited ones
 * first. Numbers of floating point that have no literal, {@code NaN}, {@code Infinity} and {@code
 * -Infinity}: models compute them, if they must; stream tests have to name them.
 */
final class ObjectTyping {
    private final UnitScope unitScope;
    private final Problems problems;
    private final BiFunction<Expression, TypeSymbol, TypedExpression> typing;

    /** What an object is made of. */
    private record Slot(String name, TypeSymbol type) {}

    /**
     * @param typing types the values of attributes
     */
    ObjectTyping(
            UnitScope unitScope,
            Problems problems,
            BiFunction<Expression, TypeSymbol, TypedExpression> typing) {
        this.unitScope = unitScope;
        this.problems = problems;
        this.typing = typing;
    }

    /** The number, where one is expected and its name is written. */
    static Optional<TypedExpression> namedReal(Expression expression, TypeSymbol expected) {
        if (!(expected.base() instanceof BuiltinType type) || !type.isReal()) {
            return Optional.empty();
        }
        boolean negative =
                expression instanceof Expression.Unary unary
                        && unary.operator() == Expression.UnaryOperator.MINUS;
        return value(negative ? expression.operands().get(0) : expression)
                .map(value -> negative ? -value : value)
                .map(value -> new TypedExpression.Literal(expression, value, type));
    }

    private static Optional<Double> value(Expression expression) {
        String name =
                expression instanceof Expression.Reference reference ? reference.name().text() : "";
        return switch (name) {
            case "NaN" -> Optional.of(Double.NaN);
            case "Infinity" -> Optional.of(Double.POSITIVE_INFINITY);
            default -> Optional.empty();
        };
    }

    /** The object that a call constructs; empty for the call of a method. */
    Optional<TypedExpression> type(Expression.Call call, TypeSymbol expected) {
        Resolution<TypeSymbol> named = named(call);
        if (named.isExcused()) {
            return Optional.of(new TypedExpression.Erroneous(call, List.of()));
        }
        Optional<TypeSymbol> type =
                named.found()
                        .filter(TypeSymbol::isObject)
                        .map(each -> isOf(expected, each) ? expected : each);
        if (type.isEmpty() && call.target().isEmpty()) {
            return Optional.of(
                    problems.erroneous(
                            Kind.UNKNOWN_NAME,
                            call,
                            "there is no class '%s' here; import it or correct the name"
                                    .formatted(call.name())));
        }
        return type.map(symbol -> object(call, symbol));
    }

    /** The class or opaque type that {@code Cup(..)} or {@code p.Types.Cup(..)} constructs. */
    private Resolution<TypeSymbol> named(Expression.Call call) {
        List<Name> parts = new ArrayList<>();
        if (call.target().isPresent()) {
            if (!(call.target().get() instanceof Expression.Reference target)) {
                return Resolution.unknown();
            }
            parts.addAll(target.name().parts());
        }
        parts.add(call.name());
        return unitScope.type(new QualifiedName(call.span(), List.copyOf(parts)));
    }

    /** {@code List("a")} is a message where some {@code List<String>} is expected. */
    private static boolean isOf(TypeSymbol expected, TypeSymbol written) {
        return expected instanceof JavaType wanted
                && written instanceof JavaType type
                && wanted.qualifiedName().equals(type.qualifiedName());
    }

    private TypedExpression object(Expression.Call call, TypeSymbol type) {
        List<Slot> attributes = slots(type);
        List<TypedExpression> values = new ArrayList<>();
        for (Expression argument : call.arguments()) {
            int i = values.size();
            TypeSymbol expected =
                    i < attributes.size() ? attributes.get(i).type() : UnknownType.UNKNOWN;
            values.add(typing.apply(argument, expected));
        }
        if (values.size() != attributes.size()) {
            problems.report(
                    Kind.OPERAND_TYPE,
                    call,
                    "%s has %s, but %s given; write one value per attribute"
                            .formatted(
                                    type.text(),
                                    count(attributes.size(), "attribute"),
                                    count(values.size(), "value")
                                            + (values.size() == 1 ? " is" : " are")));
        } else {
            for (int i = 0; i < values.size(); i++) {
                checkValue(attributes.get(i), values.get(i));
            }
        }
        // Whatever it is made of, it is plain which class is meant.
        return new TypedExpression.NewObject(call, type, values);
    }

    private static List<Slot> slots(TypeSymbol type) {
        return type instanceof ClassSymbol symbol
                ? symbol.attributes().stream().map(a -> new Slot(a.name(), a.type())).toList()
                : List.of(new Slot(OpaqueSymbol.NAME, BuiltinType.STRING));
    }

    private static String count(int number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }

    private void checkValue(Slot attribute, TypedExpression value) {
        if (!TypeRules.isAssignable(value, attribute.type())) {
            problems.report(
                    Kind.OPERAND_TYPE,
                    value.node(),
                    "attribute '%s' has type %s, not %s"
                            .formatted(
                                    attribute.name(),
                                    attribute.type().text(),
                                    value.type().text()));
        }
    }
}
