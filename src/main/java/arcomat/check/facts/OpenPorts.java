package arcomat.check.facts;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** The ports of the parts of one component at which no connector ends. */
public final class OpenPorts {
    private final boolean unclear;
    private final Set<String> used;

    private OpenPorts(boolean unclear, Set<String> used) {
        this.unclear = unclear;
        this.used = used;
    }

    public static OpenPorts in(ComponentSymbol whole) {
        boolean unclear = Connections.areUnclear(whole);
        return new OpenPorts(unclear, unclear ? Set.of() : Connections.usedKeys(whole));
    }

    /** Empty also where it cannot be told. */
    public List<PortSymbol> of(InstanceSymbol part) {
        if (unclear) {
            return List.of();
        }
        List<PortSymbol> open = new ArrayList<>();
        for (PortSymbol port : part.ports()) {
            if (!used.contains(part.name() + "." + port.name())) {
                open.add(port);
            }
        }
        return open;
    }

    public static List<String> names(List<PortSymbol> ports, Predicate<PortSymbol> choice) {
        List<String> names = new ArrayList<>();
        for (PortSymbol port : ports) {
            if (choice.test(port)) {
                names.add(port.name());
            }
        }
        return names;
    }
}
