package arcomat.check.behaviour.total;

import arcomat.check.facts.Connections;
import arcomat.check.facts.OpenPorts;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

/**
 * ARC0326: what has a message in every slice gets one in every slice. That holds for a total input
 * of a part, and for a total output of a decomposed component, which some part has to send.
 */
public final class TotalInputHasTotalSender implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ConnectorSymbol connector : Connections.own(component)) {
            checkSender(connector, findings);
        }
        OpenPorts open = OpenPorts.in(component);
        for (InstanceSymbol instance : component.ownInstances()) {
            for (PortSymbol port : open.of(instance)) {
                checkOpen(instance, port, findings);
            }
        }
    }

    private static void checkSender(ConnectorSymbol connector, Findings findings) {
        if (!connector.source().isSender() || !connector.target().isReceiver()) {
            return;
        }
        PortSymbol source = connector.source().port().orElseThrow();
        PortSymbol target = connector.target().port().orElseThrow();
        if (target.isTotal() && !source.isTotal()) {
            findings.report(
                            connector.span(),
                            "'%s' is total, but its sender '%s' may be silent; make the sender"
                                + " <<total>>, or the receiver not",
                            connector.target().text(),
                            connector.source().text())
                    .related(source.nameSpan(), "the sender")
                    .related(target.nameSpan(), "the total receiver");
        }
    }

    private static void checkOpen(InstanceSymbol instance, PortSymbol port, Findings findings) {
        if (port.isInput() && port.isTotal()) {
            findings.report(
                            instance.nameSpan(),
                            "total input '%s' of '%s' has no sender; connect it with a total one",
                            port.name(),
                            instance.name())
                    .related(port.nameSpan(), "declared <<total>> here");
        }
    }
}
