package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Exploration;
import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Situation.Alternative;
import arcomat.analysis.automaton.exploration.SureSending;
import arcomat.analysis.automaton.exploration.Traps;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.reachability.Subject;
import arcomat.source.Diagnostic;

import com.carrotsearch.hppc.IntArrayList;
import com.carrotsearch.hppc.cursors.IntCursor;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * States from which no transition that sends can be reached; completions are left aside. With
 * variables it is a matter of configurations: a counter that has run out may be a trap.
 */
final class Trap extends Analysis {
    static final String CODE = "ARC1005";

    private final List<IntArrayList> before = new ArrayList<>();
    private final BitSet sending = new BitSet();

    Trap(Subject subject) {
        super(subject);
    }

    @Override
    void see(Situation situation) {
        int number = situation.visit().number();
        if (number < 0) {
            return; // found by the solver: not all is seen, and nothing is claimed
        }
        if (!situation.faults().isEmpty()) {
            sending.set(number); // a run ends in an error there, and that is found elsewhere
        }
        for (Alternative each : situation.alternatives()) {
            if (SureSending.sends(subject, each.taken().transition()) || each.fault().isPresent()) {
                sending.set(number);
            }
            if (each.next() >= 0) {
                while (before.size() <= each.next()) {
                    before.add(new IntArrayList(1));
                }
                before.get(each.next()).add(number);
            }
        }
    }

    @Override
    List<Finding> findings(Knowledge knowledge) {
        if (!SureSending.isToSend(subject)) {
            return List.of();
        }
        if (!knowledge.isExhaustive()) {
            return knowledge.traps().entered().stream().map(this::finding).toList();
        }
        Exploration explored = knowledge.explored();
        BitSet trapped = new BitSet();
        trapped.set(0, explored.size());
        trapped.andNot(thoseThatMaySend());
        return groups(trapped, explored).stream()
                .map(group -> finding(new Traps.Entry(group.entry(), group.states(), true)))
                .toList();
    }

    private BitSet thoseThatMaySend() {
        BitSet may = (BitSet) sending.clone();
        Deque<Integer> open = new ArrayDeque<>();
        sending.stream().forEach(open::add);
        while (!open.isEmpty()) {
            for (IntCursor earlier : leadingTo(open.remove())) {
                if (!may.get(earlier.value)) {
                    may.set(earlier.value);
                    open.add(earlier.value);
                }
            }
        }
        return may;
    }

    /**
     * One trap: states that are connected within what is trapped.
     *
     * @param entry the simplest way into it
     * @param states those with a trapped configuration, by index
     */
    private record Group(Visit entry, TreeSet<Integer> states) {}

    /**
     * @param trapped numbers of visits
     */
    private List<Group> groups(BitSet trapped, Exploration explored) {
        Map<Integer, TreeSet<Integer>> groups = new TreeMap<>();
        trapped.stream()
                .map(number -> state(number, explored))
                .forEach(state -> groups.put(state, new TreeSet<>(List.of(state))));
        trapped.stream()
                .forEach(
                        number -> {
                            for (IntCursor earlier : leadingTo(number)) {
                                if (trapped.get(earlier.value)) {
                                    int state = state(earlier.value, explored);
                                    join(state, state(number, explored), groups);
                                }
                            }
                        });
        return groups.values().stream()
                .distinct()
                .map(states -> new Group(entry(trapped, states, explored), states))
                .toList();
    }

    private IntArrayList leadingTo(int number) {
        return number < before.size() ? before.get(number) : new IntArrayList();
    }

    private static int state(int visit, Exploration explored) {
        return explored.visit(visit).configuration().state();
    }

    private static void join(int one, int two, Map<Integer, TreeSet<Integer>> groups) {
        TreeSet<Integer> first = Objects.requireNonNull(groups.get(one));
        TreeSet<Integer> second = Objects.requireNonNull(groups.get(two));
        if (first != second) {
            first.addAll(second);
            second.forEach(state -> groups.put(state, first));
        }
    }

    private static Visit entry(BitSet trapped, TreeSet<Integer> states, Exploration explored) {
        return trapped.stream()
                .mapToObj(explored::visit)
                .filter(visit -> states.contains(visit.configuration().state()))
                .reduce(Visit::simpler)
                .orElseThrow();
    }

    private Finding finding(Traps.Entry entry) {
        String states =
                entry.states().stream().map(subject::state).collect(Collectors.joining(", "));
        String among = entry.isWhole() ? "; the trap is {%s}" : "; all that it may come to is {%s}";
        Diagnostic diagnostic =
                Diagnostic.warning(
                        CODE,
                        subject.automaton().places().get(entry.visit().configuration().state()),
                        "from %s on nothing is sent any more: no transition that sends can be taken%s"
                                .formatted(
                                        words(entry.visit().configuration()),
                                        entry.states().size() == 1 ? "" : among.formatted(states)));
        return finding(diagnostic, entry.visit());
    }
}
