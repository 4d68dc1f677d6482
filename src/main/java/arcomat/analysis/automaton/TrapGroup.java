package arcomat.analysis.automaton;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * One trap: states that are connected within what is trapped.
 *
 * @param entry the simplest way into it
 * @param states those with a trapped configuration, by index
 */
record TrapGroup(Visit entry, TreeSet<Integer> states) {

    /**
     * @param trapped numbers of visits
     * @param before per visit the numbers of those that lead to it
     */
    static List<TrapGroup> of(BitSet trapped, List<IntArrayList> before, Exploration explored) {
        Map<Integer, TreeSet<Integer>> groups = new TreeMap<>();
        trapped.stream()
                .map(number -> state(number, explored))
                .forEach(state -> groups.put(state, new TreeSet<>(List.of(state))));
        trapped.stream()
                .filter(number -> number < before.size())
                .forEach(
                        number -> {
                            for (int earlier : before.get(number).toArray()) {
                                if (trapped.get(earlier)) {
                                    join(state(earlier, explored), state(number, explored), groups);
                                }
                            }
                        });
        List<TrapGroup> found = new ArrayList<>();
        for (TreeSet<Integer> states :
                new TreeSet<>(groups.keySet()).stream().map(groups::get).distinct().toList()) {
            found.add(new TrapGroup(entry(trapped, states, explored), states));
        }
        return found;
    }

    private static int state(int visit, Exploration explored) {
        return explored.visit(visit).configuration().state();
    }

    private static void join(int one, int two, Map<Integer, TreeSet<Integer>> groups) {
        TreeSet<Integer> first = groups.get(one);
        TreeSet<Integer> second = groups.get(two);
        if (first != second) {
            first.addAll(second);
            second.forEach(state -> groups.put(state, first));
        }
    }

    private static Visit entry(BitSet trapped, TreeSet<Integer> states, Exploration explored) {
        return trapped.stream()
                .mapToObj(explored::visit)
                .filter(visit -> states.contains(visit.configuration().state()))
                .reduce((one, two) -> two.isSimplerThan(one) ? two : one)
                .orElseThrow();
    }
}
