package arcomat.laws.naive;

import arcomat.model.Automaton;
import arcomat.model.Expression;
import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Expression.UnaryOperator;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What expressions mean, in Kleene's three values: null is undefined, because a port carries
 * nothing.
 *
 * @param ports messages by name, null or missing where there is none
 */
record NaiveValues(Map<String, Value> ports, Map<String, Value> variables) {

    private static final Set<BinaryOperator> CONNECTIVES =
            Set.of(BinaryOperator.AND, BinaryOperator.OR, BinaryOperator.IMPLIES);

    /** A run that goes wrong. */
    static final class Wrong extends RuntimeException {
        private static final long serialVersionUID = 1L;

        Wrong() {
            super("wrong", null, false, false);
        }
    }

    /** Behind what is not true, nothing is looked at that has to be true as well. */
    boolean isTrue(Expression guard) {
        return is(true, guard);
    }

    private boolean is(boolean wanted, Expression e) {
        if (e instanceof Expression.Unary not && not.operator() == UnaryOperator.NOT) {
            return is(!wanted, not.operand());
        }
        if (e instanceof Expression.Binary binary && CONNECTIVES.contains(binary.operator())) {
            boolean oneIsEnough = wanted != (binary.operator() == BinaryOperator.AND);
            boolean first = wanted != (binary.operator() == BinaryOperator.IMPLIES);
            boolean left = is(first, binary.left());
            return left == oneIsEnough ? left : is(wanted, binary.right());
        }
        if (e instanceof Expression.Conditional choice) {
            return is(true, choice.condition())
                    ? is(wanted, choice.then())
                    : is(false, choice.condition()) && is(wanted, choice.otherwise());
        }
        return isDefined(e) && truth(wanted).equals(of(e));
    }

    /**
     * Whether an expression has a value, which is asked from left to right before anything is
     * calculated. Only what decides by itself which operands count is calculated to know that.
     */
    private boolean isDefined(Expression e) {
        if (e instanceof Expression.PortRead read) {
            return ports.get(read.port().name()) != null;
        }
        if (e instanceof Expression.PortMatches) {
            return true;
        }
        if (e instanceof Expression.Conditional choice) {
            return is(true, choice.condition())
                    ? isDefined(choice.then())
                    : is(false, choice.condition()) && isDefined(choice.otherwise());
        }
        if (e instanceof Expression.Binary binary && CONNECTIVES.contains(binary.operator())) {
            return is(true, e) || is(false, e);
        }
        return e.operands().stream().allMatch(this::isDefined);
    }

    /** Whether all messages are there that an expression reads anywhere. */
    boolean isReadable(Expression e) {
        return !e.contains(
                part ->
                        part instanceof Expression.PortRead read
                                && ports.get(read.port().name()) == null);
    }

    private static Value truth(boolean value) {
        return new Value.BooleanValue(value);
    }

    boolean matches(String port, Automaton.Pattern pattern) {
        Value found = ports.get(port);
        if (pattern instanceof Automaton.OneOf oneOf) {
            return found != null && oneOf.values().stream().anyMatch(v -> equal(found, of(v)));
        }
        return (pattern instanceof Automaton.Present) == (found != null);
    }

    Value of(Expression e) {
        if (e instanceof Expression.Constant constant) {
            return constant.value();
        }
        if (e instanceof Expression.PortRead read) {
            return ports.get(read.port().name());
        }
        if (e instanceof Expression.VariableRead read) {
            return variables.get(read.variable().name());
        }
        if (e instanceof Expression.PortMatches asked) {
            return truth(matches(asked.port().name(), asked.pattern()));
        }
        if (e instanceof Expression.AttributeRead read) {
            Value object = of(read.object());
            return object == null
                    ? null
                    : ((Value.ObjectValue) object).attributes().get(read.index());
        }
        if (e instanceof Expression.Unary unary) {
            return unary(unary);
        }
        if (e instanceof Expression.Cast cast) {
            return cast(of(cast.operand()), cast.type());
        }
        if (e instanceof Expression.IsIn isIn) {
            Value element = of(isIn.element());
            return element == null
                    ? null
                    : truth(isIn.set().stream().anyMatch(each -> equal(element, of(each))));
        }
        if (e instanceof Expression.Conditional choice) {
            Value condition = of(choice.condition());
            return condition == null
                    ? null
                    : of(condition.equals(truth(true)) ? choice.then() : choice.otherwise());
        }
        return binary((Expression.Binary) e);
    }

    private Value unary(Expression.Unary unary) {
        Value value = of(unary.operand());
        if (value == null) {
            return null;
        }
        return switch (unary.operator()) {
            case NOT -> truth(!((Value.BooleanValue) value).value());
            case NEGATE ->
                    value instanceof Value.RealValue real
                            ? new Value.RealValue(-real.value())
                            : new Value.IntegerValue(carried(-whole(value), unary.type()));
            case COMPLEMENT -> new Value.IntegerValue(~whole(value));
        };
    }

    private static Value cast(Value value, Type type) {
        if (value == null) {
            return null;
        }
        if (type instanceof Type.RealType real) {
            double number = real(value);
            return new Value.RealValue(real.single() ? (float) number : number);
        }
        if (value instanceof Value.RealValue) {
            throw new UnsupportedOperationException("cutting off reals");
        }
        return type instanceof Type.CharacterType
                ? new Value.CharacterValue((char) whole(value))
                : new Value.IntegerValue(carried(whole(value), type));
    }

    /** What is left of a number in the bits of a type. */
    private static long carried(long number, Type type) {
        return switch (((Type.IntegerType) type).width()) {
            case BYTE -> (byte) number;
            case SHORT -> (short) number;
            case INT -> (int) number;
            case LONG -> number;
        };
    }

    private Value binary(Expression.Binary binary) {
        Value left = of(binary.left());
        Value decides =
                switch (binary.operator()) {
                    case AND -> truth(false);
                    case OR -> truth(true);
                    case IMPLIES -> truth(false);
                    default -> null;
                };
        if (decides == null) {
            Value right = of(binary.right());
            return left == null || right == null ? null : strict(binary, left, right);
        }
        Value result = binary.operator() == BinaryOperator.AND ? truth(false) : truth(true);
        if (decides.equals(left)) {
            return result;
        }
        Value right = of(binary.right());
        if (result.equals(right)) {
            return result;
        }
        return left == null || right == null ? null : right;
    }

    private static Value strict(Expression.Binary binary, Value left, Value right) {
        BinaryOperator operator = binary.operator();
        return switch (operator) {
            case EQUAL, EQUIVALENT -> truth(equal(left, right));
            case NOT_EQUAL -> truth(!equal(left, right));
            case LESS -> truth(real(left) < real(right));
            case LESS_OR_EQUAL -> truth(real(left) <= real(right));
            case GREATER -> truth(real(left) > real(right));
            case GREATER_OR_EQUAL -> truth(real(left) >= real(right));
            default -> calculated(binary, left, right);
        };
    }

    private static Value calculated(Expression.Binary binary, Value left, Value right) {
        BinaryOperator operator = binary.operator();
        if (left instanceof Value.RealValue) {
            throw new UnsupportedOperationException("calculating with reals");
        }
        if (left instanceof Value.StringValue text) {
            return new Value.StringValue(text.value() + ((Value.StringValue) right).value());
        }
        long b = whole(right);
        boolean divides = operator == BinaryOperator.DIVIDE || operator == BinaryOperator.REMAINDER;
        if (divides && b == 0) {
            throw new Wrong();
        }
        long a = whole(left);
        long result =
                switch (operator) {
                    case PLUS -> a + b;
                    case MINUS -> a - b;
                    case MULTIPLY -> a * b;
                    case DIVIDE -> a / b;
                    case REMAINDER -> a % b;
                    default -> throw new AssertionError(operator);
                };
        return new Value.IntegerValue(carried(result, binary.type()));
    }

    private static long whole(Value value) {
        return value instanceof Value.CharacterValue letter
                ? letter.value()
                : ((Value.IntegerValue) value).value();
    }

    private static double real(Value value) {
        return value instanceof Value.RealValue real ? real.value() : whole(value);
    }

    private static boolean equal(Value left, Value right) {
        if (left instanceof Value.RealValue a && right instanceof Value.RealValue b) {
            return a.value() == b.value();
        }
        boolean letters =
                left instanceof Value.CharacterValue || right instanceof Value.CharacterValue;
        return letters ? whole(left) == whole(right) : left.equals(right);
    }

    /** The value, if it is one of the type. */
    static Value within(Type type, Value value) {
        if (type instanceof Type.IntegerType integer
                && (whole(value) < integer.low() || whole(value) > integer.high())) {
            throw new Wrong();
        }
        return value;
    }

    /** Every message of a type; of a large one, those in a pool. */
    static List<Value> all(Type type, List<Value> pool) {
        List<Value> all = new ArrayList<>();
        if (type instanceof Type.BooleanType) {
            return List.of(truth(false), truth(true));
        }
        if (type instanceof Type.EnumType enumeration) {
            for (int i = 0; i < enumeration.constants().size(); i++) {
                all.add(new Value.EnumValue(enumeration, i));
            }
            return all;
        }
        if (type instanceof Type.IntegerType integer && integer.ranged()) {
            for (long i = integer.low(); i <= integer.high(); i++) {
                all.add(new Value.IntegerValue(i));
            }
            return all;
        }
        pool.stream().filter(type::has).forEach(all::add);
        return all;
    }

    /** Whether {@link #all} gives all of them without a pool. */
    static boolean isSmall(Type type) {
        return type instanceof Type.BooleanType
                || type instanceof Type.EnumType
                || type instanceof Type.IntegerType integer && integer.ranged();
    }
}
