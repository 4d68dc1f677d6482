package arcomat.check.structure.connector;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ConnectorSymbol;

/** ARC0107: no connector leads from a port to the same port. */
public final class PortConnectedToItself implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        if (connector.isResolved() && connector.source().key().equals(connector.target().key())) {
            findings.report(
                    connector.span(),
                    "port '%s' is connected to itself; correct one of the ends",
                    connector.target().text());
        }
    }
}
