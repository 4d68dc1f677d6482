package arcomat.report.run;

import arcomat.model.Component;
import arcomat.model.Component.Composite;
import arcomat.model.Component.Connection;
import arcomat.model.Component.Part;

import java.util.HashMap;
import java.util.Map;

/**
 * Who sends what a port carries. Ports are named by their paths from the whole, {@code mind.speed};
 * those of a composite are the same port seen from outside and from inside.
 */
final class WireSources {
    private final Map<String, String> sources = new HashMap<>();

    WireSources(Component whole) {
        learn(whole, "");
    }

    private void learn(Component component, String prefix) {
        if (component.platform() || !(component.body() instanceof Composite composite)) {
            return;
        }
        for (Connection each : composite.connections()) {
            sources.put(prefix + each.target(), prefix + each.source());
        }
        for (Part part : composite.parts()) {
            learn(part.component(), prefix + part.name() + ".");
        }
    }

    /** The port that sends what another one carries; itself where nothing leads to it. */
    String sender(String port) {
        String found = port;
        String next = sources.get(found);
        for (int hops = 0; hops < sources.size() && next != null; hops++) {
            found = next;
            next = sources.get(found);
        }
        return found;
    }
}
