package arcomat.symbols.names;

import arcomat.tree.Argument;
import arcomat.tree.Expression;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Which features of a component are chosen.
 *
 * @param choices by the names of the features, in their order
 */
public record FeatureChoice(Map<String, Boolean> choices) {
    /** Of what has no features. */
    public static final FeatureChoice NONE = new FeatureChoice(Map.of());

    public FeatureChoice {
        choices = Collections.unmodifiableMap(new LinkedHashMap<>(choices));
    }

    /** What arguments choose, for components around with a configuration of their own. */
    public static FeatureChoice chosen(
            List<String> features, List<Argument> arguments, FeatureChoice around) {
        Map<String, Boolean> choices = new LinkedHashMap<>();
        for (String feature : features) {
            given(feature, arguments)
                    .flatMap(around::holds)
                    .ifPresent(choice -> choices.put(feature, choice));
        }
        return new FeatureChoice(choices);
    }

    /** What arguments say of a feature, the first one that names it. */
    public static Optional<Expression> given(String feature, List<Argument> arguments) {
        return arguments.stream()
                .filter(each -> each.name().filter(name -> name.text().equals(feature)).isPresent())
                .map(Argument::value)
                .findFirst();
    }

    /** Whether a condition is true; empty where it speaks of more than features and truth. */
    public Optional<Boolean> holds(Expression condition) {
        return condition.match(new FeatureCondition(choices));
    }

    /**
     * Arguments for a component that is not known: those by name that speak of these features may
     * choose some of its own, and are left out.
     */
    public List<Argument> withoutChoices(List<Argument> arguments) {
        return arguments.stream()
                .filter(each -> each.name().isEmpty() || holds(each.value()).isEmpty())
                .toList();
    }

    /** {@code (f = true, g = false)}, as arguments are written. */
    public String text() {
        return choices.entrySet().stream()
                .map(each -> each.getKey() + " = " + each.getValue())
                .collect(Collectors.joining(", ", "(", ")"));
    }
}
