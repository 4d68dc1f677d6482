package arcomat.check.stereotypes;

import arcomat.check.facts.Connections;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.signatures.Layer;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** ARC0505: messages flow from sensors to logic to actuators, and not back. */
public final class LayerOrder implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<ComponentSymbol, Optional<Layer>> layers = new HashMap<>();
        for (ConnectorSymbol connector : Connections.own(component)) {
            if (connector.source().isSender() && connector.target().isReceiver()) {
                check(connector, layers, findings);
            }
        }
    }

    private static void check(
            ConnectorSymbol connector,
            Map<ComponentSymbol, Optional<Layer>> layers,
            Findings findings) {
        Optional<Layer> from = layer(connector.source(), layers);
        Optional<Layer> to = layer(connector.target(), layers);
        if (from.isPresent() && to.isPresent() && from.get().compareTo(to.get()) > 0) {
            findings.report(
                    connector.span(),
                    "'%s' of the %s cannot send to '%s' of the %s; messages flow from sensors to"
                            + " logic to actuators",
                    connector.source().text(),
                    from.get().text(),
                    connector.target().text(),
                    to.get().text());
        }
    }

    /** A component may have many instances: its layer is looked for once. */
    private static Optional<Layer> layer(
            ConnectorSymbol.End end, Map<ComponentSymbol, Optional<Layer>> layers) {
        return end.instance()
                .flatMap(InstanceSymbol::component)
                .flatMap(component -> layers.computeIfAbsent(component, Layers::of));
    }
}
