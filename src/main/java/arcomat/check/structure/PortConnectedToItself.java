package arcomat.check.structure;

import arcomat.check.facts.Connections;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;

/** ARC0107: no connector leads from a port to the same port. */
public final class PortConnectedToItself implements Check.OnComponent {

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
