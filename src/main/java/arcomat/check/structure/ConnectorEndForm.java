package arcomat.check.structure;

import arcomat.check.facts.Connections;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;

/**
 * ARC0102: a connector ends at a port or at a port of an instance, and reaches no further. (Hab16
 * CO1, CO2)
 */
public final class ConnectorEndForm implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0102");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ConnectorSymbol connector : Connections.own(component)) {
            check(connector.source(), findings);
            check(connector.target(), findings);
        }
    }

    private static void check(End end, Findings findings) {
        if (end.status() == Status.MALFORMED) {
            String instance = end.text().substring(0, end.text().indexOf('.'));
            findings.report(
                    end.span(),
                    "'"
                            + end.text()
                            + "' reaches into '"
                            + instance
                            + "'; connect a port of '"
                            + instance
                            + "' and, inside it, that port with the part");
        }
    }
}
