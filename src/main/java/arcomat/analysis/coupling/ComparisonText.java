package arcomat.analysis.coupling;

import arcomat.model.Expression.BinaryOperator;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;

/** Reads comparisons: {@code left.n == right.m + 1}, {@code left.n <= 7}. */
final class ComparisonText {
    private static final List<BinaryOperator> EQUALITIES =
            List.of(BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL);
    private static final List<BinaryOperator> ORDERS =
            List.of(
                    BinaryOperator.LESS,
                    BinaryOperator.LESS_OR_EQUAL,
                    BinaryOperator.GREATER,
                    BinaryOperator.GREATER_OR_EQUAL);

    private final Map<String, Port> variables = new HashMap<>();

    /**
     * @param variables those that may be named
     */
    ComparisonText(List<Port> variables) {
        variables.forEach(each -> this.variables.put(each.name(), each));
    }

    /** Empty where it is no comparison of these variables. */
    Optional<Comparison> read(String text) {
        String[] words = text.split(" ", -1);
        Port variable = variables.get(words[0]);
        if (variable == null || words.length != 3 && words.length != 5) {
            return Optional.empty();
        }
        return operator(words[1], variable.type())
                .flatMap(
                        operator ->
                                measure(words, variable.type())
                                        .map(with -> new Comparison(variable, operator, with)));
    }

    private static Optional<BinaryOperator> operator(String sign, Type type) {
        Stream<BinaryOperator> all =
                isWhole(type)
                        ? Stream.concat(EQUALITIES.stream(), ORDERS.stream())
                        : EQUALITIES.stream();
        return all.filter(each -> each.sign().equals(sign)).findFirst();
    }

    private static boolean isWhole(Type type) {
        return type instanceof Type.IntegerType;
    }

    private Optional<ComparedValue> measure(String[] words, Type type) {
        boolean opposite = words[2].startsWith("-");
        Port other = variables.get(opposite ? words[2].substring(1) : words[2]);
        if (other == null) {
            return words.length == 3
                    ? value(words[2], type).map(ComparedValue::of)
                    : Optional.empty();
        }
        Optional<Long> plus = words.length == 3 ? Optional.of(0L) : plus(words[3], words[4]);
        boolean fits = isWhole(type) ? isWhole(other.type()) : type.equals(other.type());
        return plus.map(more -> ComparedValue.of(other, opposite, more))
                .filter(with -> fits && (isWhole(type) || !with.isCalculated()));
    }

    private static Optional<Long> plus(String sign, String number) {
        return whole(number)
                .filter(each -> each > 0 && (sign.equals("+") || sign.equals("-")))
                .map(each -> sign.equals("+") ? each : -each);
    }

    private static Optional<Long> whole(String text) {
        try {
            return Optional.of(Long.parseLong(text));
        } catch (NumberFormatException none) {
            return Optional.empty();
        }
    }

    private static Optional<Value> value(String text, Type type) {
        if (type instanceof Type.EnumType constants) {
            int ordinal = constants.constants().indexOf(text);
            return ordinal < 0
                    ? Optional.empty()
                    : Optional.of(new Value.EnumValue(constants, ordinal));
        }
        if (type instanceof Type.BooleanType) {
            return Stream.of(true, false)
                    .filter(truth -> text.equals(String.valueOf(truth)))
                    .<Value>map(Value.BooleanValue::new)
                    .findFirst();
        }
        return isWhole(type) ? whole(text).map(Value.IntegerValue::new) : Optional.empty();
    }
}
