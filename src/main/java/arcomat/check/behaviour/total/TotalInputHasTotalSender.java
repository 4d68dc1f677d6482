package arcomat.check.behaviour.total;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/**
 * ARC0326: what has a message in every slice gets one in every slice. That holds for a total input
 * of a part, and for a total output of a decomposed component, which some part has to send.
 */
public final class TotalInputHasTotalSender implements Check.OnConnector, Check.OnOpenPorts {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
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

    @Override
    public void check(
            InstanceSymbol part, List<PortSymbol> open, Context context, Findings findings) {
        for (PortSymbol port : open) {
            if (port.isInput() && port.isTotal()) {
                findings.report(
                                part.nameSpan(),
                                "total input '%s' of '%s' has no sender; connect it with a total"
                                        + " one",
                                port.name(),
                                part.name())
                        .related(port.nameSpan(), "declared <<total>> here");
            }
        }
    }
}
