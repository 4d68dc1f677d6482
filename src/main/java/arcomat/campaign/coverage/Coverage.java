package arcomat.campaign.coverage;

import java.util.List;
import java.util.function.ToIntFunction;

/**
 * What the runs of a campaign have covered.
 *
 * @param runs how many of them are known: they were made, and one of their programs has models
 * @param jars programs that were given as jars, without models: nobody knows what these cover
 */
public record Coverage(long runs, List<OfAutomaton> automata, List<String> jars) {
    public Coverage {
        automata = List.copyOf(automata);
        jars = List.copyOf(jars);
    }

    /**
     * Of one automaton.
     *
     * @param transitions in how many runs each was taken, in the order of the items
     * @param states how many runs were in each, likewise
     */
    public record OfAutomaton(AutomatonItems items, List<Long> transitions, List<Long> states) {
        public OfAutomaton {
            transitions = List.copyOf(transitions);
            states = List.copyOf(states);
        }

        /** How many transitions were taken in some run. */
        public int taken() {
            return covered(transitions);
        }

        /** How many states some run was in. */
        public int visited() {
            return covered(states);
        }

        private static int covered(List<Long> runs) {
            return (int) runs.stream().filter(each -> each > 0).count();
        }
    }

    /** How many transitions there are. */
    public int transitions() {
        return sum(each -> each.transitions().size());
    }

    /** How many of them were taken in some run. */
    public int taken() {
        return sum(OfAutomaton::taken);
    }

    /** How many states there are. */
    public int states() {
        return sum(each -> each.states().size());
    }

    /** How many of them some run was in. */
    public int visited() {
        return sum(OfAutomaton::visited);
    }

    private int sum(ToIntFunction<OfAutomaton> count) {
        return automata.stream().mapToInt(count).sum();
    }
}
