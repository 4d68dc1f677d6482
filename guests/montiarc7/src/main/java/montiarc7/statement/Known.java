package montiarc7.statement;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * What is known of local variables at some place: the values of those that loops count with, and
 * how those are called that a loop declares in each of its rounds.
 *
 * @param values of Integer or Long, as the variable is declared
 */
public record Known(Map<String, Number> values, Map<String, String> names) {
    public static final Known NOTHING = new Known(Map.of(), Map.of());

    public Known {
        values = Map.copyOf(values);
        names = Map.copyOf(names);
    }

    Known with(String variable, Number value) {
        Map<String, Number> more = new HashMap<>(values);
        more.put(variable, value);
        return new Known(more, names);
    }

    Known calling(String variable, String name) {
        Map<String, String> more = new HashMap<>(names);
        more.put(variable, name);
        return new Known(values, more);
    }

    /** Behind a place where all that was known was declared; what it holds now is this. */
    Known of(Known outer) {
        Map<String, Number> kept = new HashMap<>(values);
        kept.keySet().retainAll(outer.values.keySet());
        return new Known(kept, outer.names);
    }

    /** How a name is written; nothing where it is written as it is. */
    Optional<String> text(String name) {
        return values.containsKey(name)
                ? Optional.of(text(values.get(name)))
                : Optional.ofNullable(names.get(name));
    }

    boolean speaksOf(Set<String> some) {
        return some.stream().anyMatch(each -> values.containsKey(each) || names.containsKey(each));
    }

    /** The smallest number has no literal of its own. */
    private static String text(Number value) {
        String suffix = value instanceof Long ? "L" : "";
        long number = value.longValue();
        boolean least = number == Long.MIN_VALUE || suffix.isEmpty() && number == Integer.MIN_VALUE;
        String text = least ? number + 1 + suffix + " - 1" + suffix : number + suffix;
        return number < 0 ? "(" + text + ")" : text;
    }
}
