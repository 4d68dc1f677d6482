package arcomat.analysis.search.system;

import arcomat.model.Automaton;
import arcomat.model.Value;
import arcomat.semantics.automaton.ComponentSemantics;
import arcomat.semantics.automaton.Configuration;

import java.util.ArrayList;
import java.util.List;

/** Configurations in words. */
public final class ConfigurationText {
    private ConfigurationText() {}

    /** One configuration per automaton of the behaviour. */
    public static String of(ComponentSemantics behaviour, List<Configuration> configurations) {
        List<String> words = new ArrayList<>();
        for (int i = 0; i < configurations.size(); i++) {
            Configuration configuration = configurations.get(i);
            words.add(
                    configuration.isState()
                            ? of(behaviour.relations().get(i).automaton(), configuration)
                            : configuration.toString());
        }
        return String.join(", ", words);
    }

    /** The state, and the values of the variables; neither chaos nor error. */
    public static String of(Automaton automaton, Configuration configuration) {
        List<String> values = new ArrayList<>();
        List<Value> variables = configuration.variables();
        for (int i = 0; i < variables.size(); i++) {
            values.add(automaton.variables().get(i).name() + " = " + variables.get(i));
        }
        String state = automaton.states().get(configuration.state());
        return values.isEmpty() ? state : state + " (" + String.join(", ", values) + ")";
    }
}
