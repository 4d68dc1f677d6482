package arcomat.analysis.search.system;

import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Sent;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Network.Instance;

import java.util.List;

/** What is so of one part or one signal of a network, in words of the model. */
public final class NetworkWords {
    private final Network network;
    private final List<ComponentSemantics> behaviours;

    NetworkWords(Network network, List<ComponentSemantics> behaviours) {
        this.network = network;
        this.behaviours = behaviours;
    }

    /** {@code left: waiting (n = 3)}. */
    public String part(int part, List<Configuration> where) {
        return network.instances().get(part).path()
                + ": "
                + ConfigurationText.of(behaviours.get(part), where);
    }

    /** {@code left.o = true}, by who sends it. */
    public String signal(int signal, Sent message) {
        return sender(signal) + " = " + message;
    }

    private String sender(int signal) {
        for (Network.External input : network.inputs()) {
            if (input.signal() == signal) {
                return input.name();
            }
        }
        for (Instance instance : network.instances()) {
            int port = instance.outputSignals().indexOf(signal);
            if (port >= 0) {
                return instance.path() + "." + instance.component().outputs().get(port).name();
            }
        }
        throw new IllegalArgumentException("nobody sends on signal " + signal);
    }
}
