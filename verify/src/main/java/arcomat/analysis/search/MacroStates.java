package arcomat.analysis.search;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Numbers for macro states: the sets of configurations in which the subset construction says that a
 * system may be (Rabin, Scott, "Finite automata and their decision problems", 1959). Each is
 * sorted.
 */
public final class MacroStates {
    private final Map<IntKey, Integer> numbers = new HashMap<>();
    private final List<int[]> sets = new ArrayList<>();
    private final IntArrayList singletons = new IntArrayList();

    /** The number of the set of one configuration. */
    public int singleton(int configuration) {
        while (singletons.size() <= configuration) {
            singletons.add(-1);
        }
        int known = singletons.get(configuration);
        if (known < 0) {
            known = sets.size();
            sets.add(new int[] {configuration});
            singletons.set(configuration, known);
        }
        return known;
    }

    /**
     * @param some may come in any order, and more than once; sorted here
     */
    public int number(int[] some) {
        int[] members = distinct(some);
        if (members.length == 1) {
            return singleton(members[0]);
        }
        IntKey key = new IntKey(members);
        Integer known = numbers.get(key);
        if (known == null) {
            known = sets.size();
            sets.add(members);
            numbers.put(key, known);
        }
        return known;
    }

    private static int[] distinct(int[] members) {
        Arrays.sort(members);
        int count = 0;
        for (int i = 0; i < members.length; i++) {
            if (i == 0 || members[i] != members[i - 1]) {
                members[count++] = members[i];
            }
        }
        return count == members.length ? members : Arrays.copyOf(members, count);
    }

    public int[] members(int number) {
        return sets.get(number);
    }

    public boolean isSubset(int one, int other) {
        int[] small = sets.get(one);
        int[] large = sets.get(other);
        int position = 0;
        for (int member : small) {
            while (position < large.length && large[position] < member) {
                position++;
            }
            if (position == large.length || large[position] != member) {
                return false;
            }
        }
        return true;
    }
}
