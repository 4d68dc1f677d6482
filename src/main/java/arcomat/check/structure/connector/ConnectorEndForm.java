package arcomat.check.structure.connector;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;

/**
 * ARC0102: a connector ends at a port or at a port of an instance, and reaches no further. (Hab16
 * CO1, CO2)
 */
public final class ConnectorEndForm implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        check(connector.source(), findings);
        check(connector.target(), findings);
    }

    private static void check(End end, Findings findings) {
        if (end.status() == Status.MALFORMED) {
            String instance = end.text().substring(0, end.text().indexOf('.'));
            findings.report(
                    end.span(),
                    "'%s' reaches into '%s'; connect a port of '%s' and, inside it, that port with"
                            + " the part",
                    end.text(),
                    instance,
                    instance);
        }
    }
}
