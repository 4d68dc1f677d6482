package arcomat.simulate.test;

import arcomat.model.Automaton;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.List;

/** Says what it is that promises nothing any more: the model, or only a part of it. */
final class Chaos {
    private Chaos() {}

    /**
     * @param configurations per instance, one for each of its automata
     */
    static String in(Network network, int instance, List<List<Configuration>> configurations) {
        Network.Instance part = network.instances().get(instance);
        if (!part.path().isEmpty()) {
            return "part '" + part.path() + "'";
        }
        List<Automaton> automata = part.component().automata();
        List<String> lost = new ArrayList<>();
        for (int i = 0; i < automata.size(); i++) {
            if (configurations.get(instance).get(i) == Configuration.CHAOS) {
                lost.add("automaton '" + automata.get(i).name() + "'");
            }
        }
        return lost.isEmpty() || lost.size() == automata.size()
                ? somewhere(network)
                : String.join(", ", lost);
    }

    static String somewhere(Network network) {
        return network.component().isComposite() ? "a part of the model" : "the model";
    }
}
