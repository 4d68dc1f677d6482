package arcomat.check;

import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.ConnectorSymbol;

/** ARC0107: no connector leads from a port to the same port. */
final class PortConnectedToItself implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0107");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ConnectorSymbol connector : Connections.own(component)) {
            if (connector.isResolved()
                    && connector.source().key().equals(connector.target().key())) {
                findings.report(
                        connector.span(),
                        "port '"
                                + connector.target().text()
                                + "' is connected to itself; correct one of the ends");
            }
        }
    }
}
