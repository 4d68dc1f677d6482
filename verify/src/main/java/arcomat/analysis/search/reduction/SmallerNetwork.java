package arcomat.analysis.search.reduction;

import arcomat.analysis.search.Budget;
import arcomat.analysis.search.Shortcut;
import arcomat.analysis.search.composition.GlobalState;
import arcomat.model.Component;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.network.Network;
import arcomat.semantics.network.Network.Instance;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * A network without what a question cannot notice. Signals keep their numbers.
 *
 * @param network what is left
 * @param parts positions of those parts in the whole network
 * @param slots of those variables, by part and automaton
 * @param leftOut parts and variables that are not there any more, by their paths
 */
public record SmallerNetwork(
        Network network, int[] parts, List<List<int[]>> slots, List<String> leftOut) {

    /**
     * As small as the shortcuts allow that may be taken.
     *
     * @param observed signals that the question is about
     */
    public static SmallerNetwork of(Network whole, int[] observed, Budget budget) {
        BitSet inside = Cone.of(whole, observed);
        int count = whole.instances().size();
        if (inside.cardinality() < count && !budget.takes(Shortcut.CONE)) {
            inside.set(0, count);
        }
        List<String> leftOut = new ArrayList<>();
        for (int part = inside.nextClearBit(0);
                part < count;
                part = inside.nextClearBit(part + 1)) {
            leftOut.add(whole.instances().get(part).path());
        }
        Map<Component, UnreadVariables> unread = new IdentityHashMap<>();
        List<Instance> instances = new ArrayList<>();
        List<List<int[]>> slots = new ArrayList<>();
        for (int part : inside.stream().toArray()) {
            Instance instance = whole.instances().get(part);
            UnreadVariables variables =
                    unread.computeIfAbsent(instance.component(), c -> smaller(c, budget));
            instances.add(
                    new Instance(
                            instance.path(),
                            variables.component(),
                            instance.arguments(),
                            instance.inputSignals(),
                            instance.outputSignals()));
            slots.add(variables.kept());
            variables.unread().forEach(name -> leftOut.add(instance.path() + "." + name));
        }
        Network network =
                new Network(
                        whole.component(),
                        whole.arguments(),
                        instances,
                        whole.inputs(),
                        whole.outputs(),
                        whole.signals(),
                        whole.devices());
        return new SmallerNetwork(network, inside.stream().toArray(), slots, leftOut);
    }

    private static UnreadVariables smaller(Component component, Budget budget) {
        UnreadVariables all = UnreadVariables.of(component);
        return all.unread().isEmpty() || budget.takes(Shortcut.UNREAD_VARIABLES)
                ? all
                : UnreadVariables.none(component);
    }

    /** What is left of a configuration of the whole network. */
    public GlobalState image(GlobalState whole) {
        if (whole.isError()) {
            return whole;
        }
        List<List<Configuration>> configurations = new ArrayList<>();
        for (int i = 0; i < parts.length; i++) {
            configurations.add(image(whole.parts().get(parts[i]), slots.get(i)));
        }
        return new GlobalState(configurations, whole.registers());
    }

    private static List<Configuration> image(List<Configuration> part, List<int[]> slots) {
        List<Configuration> image = new ArrayList<>();
        for (int automaton = 0; automaton < slots.size(); automaton++) {
            image.add(image(part.get(automaton), slots.get(automaton)));
        }
        return image;
    }

    private static Configuration image(Configuration configuration, int[] slots) {
        if (!configuration.isState() || configuration.slots().length == slots.length) {
            return configuration;
        }
        return new Configuration(
                configuration.state(),
                Arrays.stream(slots)
                        .mapToObj(slot -> configuration.slots()[slot])
                        .toArray(Value[]::new));
    }
}
