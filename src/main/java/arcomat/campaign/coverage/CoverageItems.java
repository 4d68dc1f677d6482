package arcomat.campaign.coverage;

import java.util.List;

/**
 * What the runs of a campaign may cover, numbered from 0: all transitions, automaton by automaton,
 * then all beginnings. States need no numbers: a run was in one if it has taken a transition that
 * leads there, or begun in it.
 *
 * @param jars programs that were given as jars, without models: nobody knows what these cover
 */
public record CoverageItems(List<AutomatonItems> automata, List<String> jars) {
    /** Of programs without models. */
    public static final CoverageItems NONE = new CoverageItems(List.of(), List.of());

    public CoverageItems {
        automata = List.copyOf(automata);
        jars = List.copyOf(jars);
    }

    /** How many transitions there are; their numbers are below that. */
    public int transitions() {
        return automata.stream().mapToInt(each -> each.transitions().size()).sum();
    }

    /** How many states there are. */
    public int states() {
        return automata.stream().mapToInt(each -> each.states().size()).sum();
    }

    /**
     * The number of a transition.
     *
     * @param automaton its place among the automata
     * @param index its place in the automaton
     */
    public int transition(int automaton, int index) {
        return automata.stream().limit(automaton).mapToInt(a -> a.transitions().size()).sum()
                + index;
    }

    /** The number of a beginning, likewise. */
    public int initial(int automaton, int index) {
        return transitions()
                + automata.stream().limit(automaton).mapToInt(a -> a.initials().size()).sum()
                + index;
    }
}
