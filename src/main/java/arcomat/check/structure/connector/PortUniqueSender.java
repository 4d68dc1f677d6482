package arcomat.check.structure.connector;

import arcomat.check.facts.Connections;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;

import java.util.HashMap;
import java.util.Map;

/** ARC0104: each receiver has at most one sender; connectors fan out, never in. (Hab16 R1, R2) */
public final class PortUniqueSender implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        Map<String, ConnectorSymbol> first = new HashMap<>();
        for (ConnectorSymbol connector : component.connectors()) {
            if (connector.target().isReceiver()) {
                ConnectorSymbol other = first.putIfAbsent(connector.target().key(), connector);
                if (other != null && Connections.isOwn(connector, component)) {
                    report(connector, other, findings);
                }
            }
        }
    }

    private static void report(
            ConnectorSymbol connector, ConnectorSymbol other, Findings findings) {
        boolean same = connector.source().key().equals(other.source().key());
        findings.report(
                        connector.span(),
                        same
                                ? "port '%s' is connected with '%s' twice; delete one of the"
                                        + " connectors"
                                : "port '%s' has '%s' as its sender already; a port has one sender"
                                        + " only",
                        connector.target().text(),
                        other.source().text())
                .related(other.span(), "the first sender is connected here");
    }
}
