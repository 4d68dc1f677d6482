package arcomat.campaign.coverage;

import java.util.List;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;

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
     * Of one automaton, whichever part came to it.
     *
     * @param transitions in how many runs each was taken, in the order of the items
     * @param states how many runs were in each, likewise
     * @param parts the same for each part that has it
     */
    public record OfAutomaton(
            AutomatonItems items, List<Long> transitions, List<Long> states, List<OfPart> parts) {
        public OfAutomaton {
            transitions = List.copyOf(transitions);
            states = List.copyOf(states);
            parts = List.copyOf(parts);
        }

        private OfAutomaton and(OfAutomaton further) {
            return new OfAutomaton(
                    items,
                    sums(transitions, further.transitions),
                    sums(states, further.states),
                    both(parts, further.parts));
        }

        private static List<OfPart> both(List<OfPart> some, List<OfPart> further) {
            return IntStream.range(0, some.size())
                    .mapToObj(i -> some.get(i).and(further.get(i)))
                    .toList();
        }

        /** How many transitions were taken in some run. */
        public int taken() {
            return covered(transitions);
        }

        /** How many states some run was in. */
        public int visited() {
            return covered(states);
        }
    }

    /**
     * Of one part of a robot.
     *
     * @param number of its first transition
     * @param transitions in how many runs it has taken each, in the order of the items
     * @param states in how many runs it was in each, likewise
     */
    public record OfPart(PartItems part, int number, List<Long> transitions, List<Long> states) {
        public OfPart {
            transitions = List.copyOf(transitions);
            states = List.copyOf(states);
        }

        private OfPart and(OfPart further) {
            return new OfPart(
                    part,
                    number,
                    sums(transitions, further.transitions),
                    sums(states, further.states));
        }

        /** How many transitions it has taken in some run. */
        public int taken() {
            return covered(transitions);
        }

        /** How many states it was in in some run. */
        public int visited() {
            return covered(states);
        }
    }

    private static List<Long> sums(List<Long> one, List<Long> other) {
        return IntStream.range(0, one.size()).mapToObj(i -> one.get(i) + other.get(i)).toList();
    }

    private static int covered(List<Long> runs) {
        return (int) runs.stream().filter(each -> each > 0).count();
    }

    /**
     * With further runs.
     *
     * @param further of the same items
     */
    public Coverage and(Coverage further) {
        List<OfAutomaton> all =
                IntStream.range(0, automata.size())
                        .mapToObj(i -> automata.get(i).and(further.automata.get(i)))
                        .toList();
        return new Coverage(runs + further.runs, all, jars);
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

    /** Whether several parts have one automaton. */
    public boolean isShared() {
        return automata.stream().anyMatch(each -> each.parts().size() > 1);
    }

    /** The parts of all robots, automaton by automaton. */
    public List<OfPart> parts() {
        return automata.stream().flatMap(each -> each.parts().stream()).toList();
    }
}
