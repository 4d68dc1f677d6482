package arcomat.laws.naive;

import arcomat.laws.naive.NaiveAutomata.Place;
import arcomat.model.Automaton;
import arcomat.model.Component;
import arcomat.model.Value;

import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * What can be seen of a component, by writing out all that may happen. It knows the records of the
 * model and nothing else of Arcomat: it says once more what {@code docs/semantics.md} says.
 */
public sealed interface NaiveBehaviour permits NaiveSlices, NaiveEvents {

    /**
     * Between two slices, or two events.
     *
     * @param parts where the automata of each part are
     * @param kept per signal what is visible in the next slice; per latched port its value
     */
    record State(List<List<Place>> parts, Map<String, Slot> kept) {}

    /**
     * @param outputs what is seen of the ports that react at once
     */
    record Move(Map<String, Slot> outputs, State next) {}

    /**
     * All that may happen on one input.
     *
     * @param error whether the run may end in an error
     */
    record Moves(Set<Move> moves, boolean error) {}

    Component component();

    /** The beginnings; the outputs are those of the event-driven profile. */
    Moves starts();

    Moves moves(State before, Map<String, Value> input);

    /** Whether an output shows in a slice what was sent before it. */
    boolean isLate(String output);

    /** Whether an output is fed; if not, it is silent. */
    boolean isConnected(String output);

    /** What a late output shows in the next slice. */
    Slot due(State state, String output);

    /** Whether an output may depend on an input of the same slice. */
    boolean isAtOnce(String input, String output);

    /**
     * @param automata those of the component that count; empty for what its parts do
     * @param pool messages of large types that are tried where one is left open
     * @param writtenOut whether outputs that are left open are written out
     */
    static NaiveBehaviour of(
            Component component, List<Automaton> automata, List<Value> pool, boolean writtenOut) {
        NaiveNetwork network = NaiveNetwork.of(component, automata);
        return component.profile() == Component.Profile.EVENT_DRIVEN
                ? new NaiveEvents(network, pool, writtenOut)
                : new NaiveSlices(network, pool, writtenOut);
    }
}
