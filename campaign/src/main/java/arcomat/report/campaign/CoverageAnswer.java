package arcomat.report.campaign;

import arcomat.campaign.coverage.AutomatonItems;
import arcomat.campaign.coverage.Coverage;

import java.util.ArrayList;
import java.util.List;

/**
 * What runs have covered, in the form of JSON.
 *
 * @param runs how many of them are known
 * @param jars programs that were given as jars: nobody knows what these cover
 */
record CoverageAnswer(
        long runs,
        int transitions,
        int taken,
        int states,
        int visited,
        List<String> jars,
        List<OfAutomaton> automata) {
    /** Of the automaton of one component. */
    record OfAutomaton(
            String component,
            String file,
            List<OfTransition> transitions,
            List<OfState> states,
            List<OfPart> parts) {}

    /**
     * Of a transition.
     *
     * @param number in the column {@code taken} of the table
     * @param coded whether the program has it: another one may always be taken first
     * @param runs in how many it was taken
     */
    record OfTransition(int number, int line, String text, boolean coded, long runs) {}

    /** Of a state, with the number of runs that were in it. */
    record OfState(int line, String name, long runs) {}

    /**
     * Of one part of a robot that has the automaton.
     *
     * @param part {@code ROBOT.PATH}
     * @param number of its first transition in the column {@code taken}; the others follow
     * @param transitions in how many runs it has taken each, in the order of the automaton's
     * @param states in how many runs it was in each, likewise
     */
    record OfPart(String part, int number, List<Long> transitions, List<Long> states) {}

    static CoverageAnswer of(Coverage coverage) {
        List<OfAutomaton> automata = new ArrayList<>();
        int first = 0;
        for (Coverage.OfAutomaton each : coverage.automata()) {
            automata.add(of(each, first));
            first += each.transitions().size();
        }
        return new CoverageAnswer(
                coverage.runs(),
                coverage.transitions(),
                coverage.taken(),
                coverage.states(),
                coverage.visited(),
                coverage.jars(),
                automata);
    }

    private static OfAutomaton of(Coverage.OfAutomaton covered, int first) {
        AutomatonItems items = covered.items();
        List<OfTransition> transitions = new ArrayList<>();
        for (AutomatonItems.Transition each : items.transitions()) {
            int i = transitions.size();
            transitions.add(
                    new OfTransition(
                            first + i,
                            each.line(),
                            each.text(),
                            each.coded(),
                            covered.transitions().get(i)));
        }
        List<OfState> states = new ArrayList<>();
        for (AutomatonItems.State each : items.states()) {
            states.add(new OfState(each.line(), each.name(), covered.states().get(states.size())));
        }
        return new OfAutomaton(
                items.component(),
                items.file(),
                transitions,
                states,
                covered.parts().stream().map(CoverageAnswer::of).toList());
    }

    private static OfPart of(Coverage.OfPart covered) {
        return new OfPart(
                covered.part().name(), covered.number(), covered.transitions(), covered.states());
    }
}
