package arcomat.live.picture;

import java.util.IdentityHashMap;
import java.util.Map;

/** Short names by which the page's engine gives back what it was asked about. */
final class Names {
    static final String ROOT = "root";

    private final Map<Object, String> names = new IdentityHashMap<>();

    /** The same one for the same thing; things that are equal are still two. */
    String of(Object element) {
        return names.computeIfAbsent(element, each -> "e" + names.size());
    }
}
