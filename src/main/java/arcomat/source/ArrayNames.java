package arcomat.source;

import java.util.Collection;
import java.util.Optional;

/**
 * Elements of arrays have names of their own: {@code wheel[0]} and {@code wheel[1]} are two things
 * in every room, and nobody but these rules knows that they are declared together.
 */
public final class ArrayNames {
    /** Elements of one array: more are no model that somebody reads. */
    public static final int MOST = 256;

    private ArrayNames() {}

    public static String element(String array, int index) {
        return array + "[" + index + "]";
    }

    public static boolean isElement(String name) {
        return name.endsWith("]");
    }

    /** Of which array something is an element. */
    public static String array(String element) {
        return element.substring(0, element.lastIndexOf('['));
    }

    /**
     * Where the name of an array stands that is a place, with a size or a number behind it, or with
     * a size and other names in front of it.
     */
    public static Span word(Span place, String array) {
        return place.text().startsWith("[")
                ? place.file().span(place.end() - array.length(), place.end())
                : place.file().span(place.start(), place.start() + array.length());
    }

    /** The size that stands where an array is declared, as it is written. */
    public static String writtenSize(Span declaration) {
        String text = declaration.text();
        return text.substring(text.indexOf('[') + 1, text.indexOf(']')).strip();
    }

    /** How many elements an array has; none of what is no array. */
    public static int size(String array, Collection<String> names) {
        int size = 0;
        while (names.contains(element(array, size))) {
            size++;
        }
        return size;
    }

    /**
     * What to say of a name that nothing has: the whole of an array, or an element that it does not
     * have.
     */
    public static Optional<String> hint(String name, Collection<String> names) {
        String array = isElement(name) ? array(name) : name;
        int size = size(array, names);
        if (size == 0) {
            return Optional.empty();
        }
        String last = element(array, size - 1);
        String elements = size == 1 ? last : element(array, 0) + " to " + last;
        return Optional.of(
                isElement(name)
                        ? "; the array has " + elements
                        : "; it is an array, name one of " + elements);
    }
}
