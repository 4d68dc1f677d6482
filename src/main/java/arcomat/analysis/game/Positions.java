package arcomat.analysis.game;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Numbers for positions: the sets that the requirements are in, one per requirement. */
final class Positions {
    private record Key(int[] sets) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Key key && Arrays.equals(sets, key.sets);
        }

        @Override
        public int hashCode() {
            int hash = 0;
            for (int set : sets) {
                hash = (hash + set) * 0x9E3779B1;
            }
            return hash ^ hash >>> 15;
        }
    }

    private final Map<Key, Integer> numbers = new HashMap<>();
    private final List<int[]> positions = new ArrayList<>();

    int number(int[] sets) {
        Key key = new Key(sets);
        Integer known = numbers.get(key);
        if (known == null) {
            known = positions.size();
            numbers.put(key, known);
            positions.add(sets);
        }
        return known;
    }

    int[] sets(int position) {
        return positions.get(position);
    }

    int size() {
        return positions.size();
    }
}
