package arcomat.analysis.coupling;

import arcomat.model.Port;
import arcomat.model.Type;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads comparisons: {@code left.n == right.m + 1}, {@code left.n <= 7}, {@code left.text == "on"},
 * {@code left.d is right.e}, {@code !(left.d > 7.5)}.
 */
final class ComparisonText {
    private final Map<String, Port> variables = new HashMap<>();

    /**
     * @param variables those that may be named
     */
    ComparisonText(List<Port> variables) {
        variables.forEach(each -> this.variables.put(each.name(), each));
    }

    /** Empty where it is no comparison of these variables. */
    Optional<Comparison> read(String text) {
        boolean denied = Relation.isDenied(text);
        String[] words = (denied ? Relation.undenied(text) : text).split(" ", 3);
        Port variable = variables.get(words[0]);
        return variable == null || words.length < 3
                ? Optional.empty()
                : Relation.of(words[1], denied, variable.type())
                        .flatMap(
                                relation ->
                                        measure(words[2], variable.type())
                                                .map(w -> new Comparison(variable, relation, w)));
    }

    private static boolean isWhole(Type type) {
        return type instanceof Type.IntegerType;
    }

    private Optional<ComparedValue> measure(String text, Type type) {
        boolean opposite = text.startsWith("-");
        String[] words = text.split(" ", -1);
        Port other = variables.get(opposite ? words[0].substring(1) : words[0]);
        if (other == null) {
            return new ValueText(text).of(type).map(ComparedValue::of);
        }
        Optional<Long> plus =
                switch (words.length) {
                    case 1 -> Optional.of(0L);
                    case 3 -> plus(words[1], words[2]);
                    default -> Optional.empty();
                };
        return plus.filter(more -> fits(other.type(), opposite, more, type))
                .map(more -> ComparedValue.of(other, opposite, more));
    }

    private static boolean fits(Type other, boolean opposite, long plus, Type type) {
        return isWhole(type)
                ? isWhole(other)
                : type.equals(other) && plus == 0 && (!opposite || type instanceof Type.RealType);
    }

    private static Optional<Long> plus(String sign, String number) {
        return ValueText.whole(number)
                .filter(each -> each > 0 && (sign.equals("+") || sign.equals("-")))
                .map(each -> sign.equals("+") ? each : -each);
    }
}
