package arcomat.check;

import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.InstanceSymbol;
import arcomat.symbols.PortSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** The ports of parts at which no connector ends. */
final class OpenPorts {
    private OpenPorts() {}

    /** Empty also where that cannot be told. */
    static List<PortSymbol> of(InstanceSymbol instance) {
        ComponentSymbol whole = instance.owner();
        if (Connections.areUnclear(whole)) {
            return List.of();
        }
        Set<String> used = Connections.usedKeys(whole);
        List<PortSymbol> open = new ArrayList<>();
        for (PortSymbol port : instance.ports()) {
            if (!used.contains(instance.name() + "." + port.name())) {
                open.add(port);
            }
        }
        return open;
    }

    static List<String> names(List<PortSymbol> ports, Predicate<PortSymbol> choice) {
        List<String> names = new ArrayList<>();
        for (PortSymbol port : ports) {
            if (choice.test(port)) {
                names.add(port.name());
            }
        }
        return names;
    }
}
