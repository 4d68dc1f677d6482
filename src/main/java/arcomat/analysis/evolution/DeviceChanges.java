package arcomat.analysis.evolution;

import arcomat.analysis.refinement.Promise;
import arcomat.analysis.refinement.Verdict.Sentence;
import arcomat.semantics.network.Network;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * What is different about the devices of a composition: a motor at another port of the brick is
 * another motor. Ports are compared elsewhere.
 */
final class DeviceChanges {
    private DeviceChanges() {}

    /** A sentence for each device of the old one that is something else in the new one. */
    static List<Sentence> between(Promise old, Promise fresh) {
        if (!old.isComposition() || !fresh.isComposition()) {
            return List.of();
        }
        Map<String, Network.Device> now = new HashMap<>();
        network(fresh).devices().forEach(device -> now.put(device.path(), device));
        List<Sentence> changes = new ArrayList<>();
        for (Network.Device device : network(old).devices()) {
            Network.Device successor = now.get(device.path());
            if (successor != null && !words(device).equals(words(successor))) {
                changes.add(
                        new Sentence(
                                "'%s' is %s in %s and %s in %s"
                                        .formatted(
                                                device.path(),
                                                words(successor),
                                                fresh.title(),
                                                words(device),
                                                old.title()),
                                Optional.of(fresh.component().span())));
            }
        }
        return changes;
    }

    private static Network network(Promise promise) {
        return Network.of(promise.component(), promise.arguments());
    }

    private static String words(Network.Device device) {
        return Promise.title(device.component(), device.arguments());
    }
}
