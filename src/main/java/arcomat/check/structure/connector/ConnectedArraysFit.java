package arcomat.check.structure.connector;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Status;

/** ARC0145: a whole array is connected to one that has as many elements. */
public final class ConnectedArraysFit implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        if (connector.source().status() == Status.OTHER_SIZE
                && connector.target().status() == Status.OTHER_SIZE) {
            findings.report(
                    connector.span(),
                    "%s, but %s; connect as many, or name elements",
                    words(connector.source()),
                    words(connector.target()));
        }
    }

    private static String words(End end) {
        return end.text().equals("1")
                ? "'%s' is one port".formatted(end.span().text())
                : "'%s' has %s elements".formatted(end.span().text(), end.text());
    }
}
