package arcomat.simulate.test;

import arcomat.model.Automaton;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.ComponentSemantics.Prospect;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.automaton.Input;
import arcomat.semantics.network.Network;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** What the instances of a network may do, and why some run could not go on. */
abstract class AllowedBehaviour {
    final Network network;
    final List<ComponentSemantics> behaviours;
    @Nullable String lastProblem;

    AllowedBehaviour(Network network) {
        this.network = network;
        this.behaviours = ComponentSemantics.ofParts(network);
    }

    /** Why the last run that could not go on could not. */
    Optional<String> lastProblem() {
        return Optional.ofNullable(lastProblem);
    }

    /** All that an instance may do, with a note of what goes wrong. */
    Prospect prospect(int instance, List<Configuration> configurations, Input input) {
        Prospect prospect = behaviours.get(instance).prospect(configurations, input);
        Network.Instance part = network.instances().get(instance);
        prospect.errors().forEach(error -> lastProblem = part.with(error.message()));
        if (prospect.isContradiction()) {
            lastProblem = part.with("its automata contradict each other");
        }
        return prospect;
    }

    /** Whether an instance promises nothing any more. */
    static boolean isChaotic(List<Configuration> configurations) {
        return configurations.isEmpty() || configurations.contains(Configuration.CHAOS);
    }

    /**
     * What it is that promises nothing any more, in words: the model, or only a part of it.
     *
     * @param configurations per instance, one for each of its automata
     */
    static String chaos(Network network, int instance, List<List<Configuration>> configurations) {
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
                ? chaosSomewhere(network)
                : String.join(", ", lost);
    }

    static String chaosSomewhere(Network network) {
        return network.component().isComposite() ? "a part of the model" : "the model";
    }

    /** What a run stands for that shows what a test expects. The best of several counts. */
    enum Standing {
        /** The model may do this. */
        SURE,
        /** It may, but something was allowed, or guessed, only since something is in chaos. */
        VACUOUS,
        /** Not all that is left open could be tried: perhaps the model may not do this. */
        LOOSE;

        /** That of a run that has both behind it. */
        Standing and(Standing other) {
            return compareTo(other) < 0 ? other : this;
        }

        boolean isBetterThan(Standing other) {
            return compareTo(other) < 0;
        }
    }
}
