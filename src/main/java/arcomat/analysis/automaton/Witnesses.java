package arcomat.analysis.automaton;

import java.util.Optional;
import java.util.TreeMap;

/**
 * The simplest situation for each thing that may be found; of equally simple ones the first.
 *
 * @param <K> what is found, in the order of the findings
 */
final class Witnesses<K extends Comparable<K>> {
    private final TreeMap<K, Situation> found = new TreeMap<>();

    void add(K key, Situation situation) {
        Situation known = found.get(key);
        if (known == null || situation.isSimplerThan(known)) {
            found.put(key, situation);
        }
    }

    Optional<Situation> of(K key) {
        return Optional.ofNullable(found.get(key));
    }

    /** Ordered by key. */
    TreeMap<K, Situation> all() {
        return found;
    }
}
