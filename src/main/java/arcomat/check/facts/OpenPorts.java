package arcomat.check.facts;

import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;
import java.util.Set;

/**
 * The ports of the parts of one component at which no connector ends. The parts of a map stand
 * beside each other, and whoever asks connects them.
 *
 * @param unclear whether that cannot be told
 * @param used the keys of the ports at which one does
 */
public record OpenPorts(boolean unclear, Set<String> used) {

    public static OpenPorts in(ComponentSymbol whole) {
        boolean unclear = whole.signature().isMap() || Connections.areUnclear(whole);
        return new OpenPorts(unclear, unclear ? Set.of() : Connections.usedKeys(whole));
    }

    /** Empty also where it cannot be told. */
    public List<PortSymbol> of(InstanceSymbol part) {
        if (unclear) {
            return List.of();
        }
        return part.ports().stream()
                .filter(port -> !used.contains(part.name() + "." + port.name()))
                .toList();
    }

    /** The names of the inputs; total ones are the business of other laws. */
    public static List<String> inputs(List<PortSymbol> open) {
        return open.stream()
                .filter(port -> port.isInput() && !port.isTotal())
                .map(PortSymbol::name)
                .toList();
    }

    public static List<String> outputs(List<PortSymbol> open) {
        return open.stream().filter(PortSymbol::isOutput).map(PortSymbol::name).toList();
    }
}
