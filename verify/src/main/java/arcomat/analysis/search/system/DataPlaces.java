package arcomat.analysis.search.system;

import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.DataSorts;
import arcomat.semantics.expression.Sent;

import java.util.List;
import java.util.Map;

/**
 * Where a system has data, as places of {@link DataSorts}.
 *
 * @param inputs by name of the port
 * @param outputs by position of the compared port; {@link #NOWHERE} if there is none
 * @param memory tells all values that a configuration may still use
 */
record DataPlaces(Map<String, Integer> inputs, List<Integer> outputs, Memory memory) {
    static final int NOWHERE = -1;

    /** What configurations hold. */
    interface Memory {
        void tell(int configuration, Holding holding);
    }

    /** Told of a value at a place. */
    interface Holding {
        void value(int place, Value value);

        /**
         * Told of what automata hold.
         *
         * @param places of the variables, per automaton
         */
        default void values(List<Configuration> automata, List<int[]> places) {
            for (int i = 0; i < automata.size(); i++) {
                List<Value> values = automata.get(i).variables();
                for (int slot = 0; slot < values.size(); slot++) {
                    value(places.get(i)[slot], values.get(slot));
                }
            }
        }

        /** Told of what is on its way. */
        default void values(Sent sent, int place) {
            if (sent instanceof Sent.Messages messages) {
                messages.values().forEach(value -> value(place, value));
            }
        }
    }

    /** The place of an input port, by its name; {@link #NOWHERE} if there is none. */
    int input(String port) {
        return inputs.getOrDefault(port, NOWHERE);
    }
}
