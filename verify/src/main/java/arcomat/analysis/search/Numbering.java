package arcomat.analysis.search;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Numbers for things, from 0 in the order in which they are met.
 *
 * @param <T> what is numbered, by equality
 */
public final class Numbering<T> {
    private final Map<T, Integer> numbers = new HashMap<>();
    private final List<T> things = new ArrayList<>();

    /** The number of a thing; a new one gets the next. */
    public int number(T thing) {
        Integer known = numbers.get(thing);
        if (known == null) {
            known = things.size();
            numbers.put(thing, known);
            things.add(thing);
        }
        return known;
    }

    public T get(int number) {
        return things.get(number);
    }

    /** How many things have been met. */
    public int size() {
        return things.size();
    }
}
