package arcomat.campaign.coverage;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Counts the runs that came to each item. A million runs take it no more memory than one. */
public final class CoverageCount {
    private final List<OneAutomaton> automata = new ArrayList<>();
    private final List<String> jars;
    private long runs;

    public CoverageCount(CoverageItems items) {
        jars = items.jars();
        for (int i = 0; i < items.automata().size(); i++) {
            automata.add(new OneAutomaton(items, i));
        }
    }

    /** The next run. */
    public void see(ReachedItems reached) {
        if (reached.isKnown()) {
            runs++;
            automata.forEach(each -> each.see(reached));
        }
    }

    public Coverage coverage() {
        return new Coverage(runs, automata.stream().map(OneAutomaton::coverage).toList(), jars);
    }

    private static final class OneAutomaton {
        private final AutomatonItems items;
        private final int firstTransition;
        private final int firstInitial;
        private final long[] transitions;
        private final long[] states;
        private final boolean[] visited;

        OneAutomaton(CoverageItems all, int place) {
            items = all.automata().get(place);
            firstTransition = all.transition(place, 0);
            firstInitial = all.initial(place, 0);
            transitions = new long[items.transitions().size()];
            states = new long[items.states().size()];
            visited = new boolean[states.length];
        }

        void see(ReachedItems reached) {
            Arrays.fill(visited, false);
            for (int i = 0; i < transitions.length; i++) {
                if (reached.contains(firstTransition + i)) {
                    transitions[i]++;
                    visited[items.transitions().get(i).target()] = true;
                }
            }
            for (int i = 0; i < items.initials().size(); i++) {
                if (reached.contains(firstInitial + i)) {
                    visited[items.initials().get(i)] = true;
                }
            }
            for (int i = 0; i < states.length; i++) {
                states[i] += visited[i] ? 1 : 0;
            }
        }

        Coverage.OfAutomaton coverage() {
            return new Coverage.OfAutomaton(
                    items,
                    Arrays.stream(transitions).boxed().toList(),
                    Arrays.stream(states).boxed().toList());
        }
    }
}
