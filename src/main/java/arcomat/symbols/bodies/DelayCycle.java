package arcomat.symbols.bodies;

import java.util.List;
import java.util.stream.Collectors;

/**
 * A cycle of messages in which nothing is delayed.
 *
 * @param component whose connectors close the cycle
 * @param instances in the order in which messages run, the first not repeated
 * @param connectors that lie on the cycle, in the same order
 */
public record DelayCycle(
        ComponentSymbol component,
        List<InstanceSymbol> instances,
        List<ConnectorSymbol> connectors) {
    public DelayCycle {
        instances = List.copyOf(instances);
        connectors = List.copyOf(connectors);
    }

    /** {@code ctrl -> timer -> ctrl}. */
    public String text() {
        return instances.stream().map(InstanceSymbol::name).collect(Collectors.joining(" -> "))
                + " -> "
                + instances.get(0).name();
    }
}
