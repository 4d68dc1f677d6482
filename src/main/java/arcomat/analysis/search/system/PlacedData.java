package arcomat.analysis.search.system;

import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;

import java.util.List;
import java.util.Map;

/** Data of a side whose ports have places. */
abstract class PlacedData implements DataPlaces {
    private final Map<String, Integer> inputs;
    private final List<Integer> outputs;

    /**
     * @param inputs places by the name of the port
     * @param outputs of the compared ports
     */
    PlacedData(Map<String, Integer> inputs, List<Integer> outputs) {
        this.inputs = inputs;
        this.outputs = outputs;
    }

    @Override
    public int input(String port) {
        return inputs.getOrDefault(port, NOWHERE);
    }

    @Override
    public int output(int observed) {
        return outputs.get(observed);
    }

    /**
     * What automata hold.
     *
     * @param places of the variables, per automaton
     */
    static void held(List<Configuration> automata, List<int[]> places, Holding holding) {
        for (int i = 0; i < automata.size(); i++) {
            List<Value> values = automata.get(i).variables();
            for (int slot = 0; slot < values.size(); slot++) {
                holding.value(places.get(i)[slot], values.get(slot));
            }
        }
    }

    /** What is on its way. */
    static void held(Sent sent, int place, Holding holding) {
        if (sent instanceof Sent.Messages messages) {
            messages.values().forEach(value -> holding.value(place, value));
        }
    }
}
