package arcomat.check.structure.connector;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.tree.Element;

import java.util.List;

/** ARC0105: a connector leads from a port that sends to one that receives. */
public final class ConnectorDirection implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        if (!connector.source().key().equals(connector.target().key())) {
            check(context.component().orElseThrow(), connector, findings);
        }
    }

    private static void check(
            ComponentSymbol component, ConnectorSymbol connector, Findings findings) {
        boolean sourceWrong = connector.source().isReceiver();
        boolean targetWrong = connector.target().isSender();
        if (sourceWrong && targetWrong) {
            reportReversed(connector, findings);
        } else if (sourceWrong) {
            findings.report(
                    connector.source().span(),
                    "%s and receives here; a connector starts at a port that sends",
                    name(component, connector.source()));
        } else if (targetWrong) {
            findings.report(
                    connector.target().span(),
                    "%s and sends here; a connector leads to a port that receives",
                    name(component, connector.target()));
        }
    }

    private static void reportReversed(ConnectorSymbol connector, Findings findings) {
        Span source = connector.source().span();
        Span target = connector.target().span();
        findings.report(
                source.to(target),
                "this connector leads from the receiver '%s' to the sender '%s'; turn it round",
                connector.source().text(),
                connector.target().text());
        if (connector.node() instanceof Element.Connector node && node.targets().size() == 1) {
            findings.fix(
                    new Fix(
                            "Turn the connector round",
                            List.of(
                                    new TextEdit(source, target.text()),
                                    new TextEdit(target, source.text()))));
        }
    }

    /** {@code "'motor.power' is an input of 'motor'"}. */
    private static String name(ComponentSymbol component, End end) {
        String owner = end.instance().map(i -> i.name()).orElse(component.name());
        String kind = end.port().orElseThrow().isInput() ? "an input" : "an output";
        return "'" + end.text() + "' is " + kind + " of '" + owner + "'";
    }
}
