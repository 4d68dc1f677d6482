package arcomat.check;

import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.ConnectorSymbol;
import arcomat.symbols.InstanceSymbol;
import arcomat.symbols.Layer;

import java.util.Optional;

/** ARC0505: messages flow from sensors to logic to actuators, and not back. */
final class LayerOrder implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0505");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ConnectorSymbol connector : Connections.own(component)) {
            if (connector.source().isSender() && connector.target().isReceiver()) {
                check(connector, findings);
            }
        }
    }

    private static void check(ConnectorSymbol connector, Findings findings) {
        Optional<Layer> from = layer(connector.source());
        Optional<Layer> to = layer(connector.target());
        if (from.isPresent() && to.isPresent() && from.get().compareTo(to.get()) > 0) {
            findings.report(
                    connector.span(),
                    "'"
                            + connector.source().text()
                            + "' of the "
                            + from.get().text()
                            + " cannot send to '"
                            + connector.target().text()
                            + "' of the "
                            + to.get().text()
                            + "; messages flow from sensors to logic to actuators");
        }
    }

    private static Optional<Layer> layer(ConnectorSymbol.End end) {
        return end.instance().flatMap(InstanceSymbol::component).flatMap(Layers::of);
    }
}
