package arcomat.live.robot;

import arcomat.model.Component;
import arcomat.semantics.network.Composition;
import arcomat.semantics.network.Composition.Node;

import java.util.ArrayList;
import java.util.List;

/**
 * In which order a program works its devices, by their paths.
 *
 * @param sensed made and sampled: in the order of the schedule
 * @param acted those of a composite behind all of its logic
 */
record DeviceOrder(List<String> sensed, List<String> acted) {
    DeviceOrder {
        sensed = List.copyOf(sensed);
        acted = List.copyOf(acted);
    }

    static DeviceOrder of(Component whole) {
        List<String> sensed = new ArrayList<>();
        List<String> acted = new ArrayList<>();
        add(Composition.of(whole), "", sensed, acted);
        return new DeviceOrder(sensed, acted);
    }

    private static void add(
            Composition composition, String before, List<String> sensed, List<String> acted) {
        for (Node node : composition.nodes()) {
            String path = before + node.path();
            if (node.component().platform()) {
                sensed.add(path);
            }
            node.inside().ifPresent(inside -> add(inside, path + ".", sensed, acted));
        }
        composition.nodes().stream()
                .filter(node -> node.component().platform())
                .forEach(node -> acted.add(before + node.path()));
    }
}
