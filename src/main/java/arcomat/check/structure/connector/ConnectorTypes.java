package arcomat.check.structure.connector;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypeRules;

/** ARC0106: what the source of a connector sends, its target can receive. (Hab16 R8) */
public final class ConnectorTypes implements Check.OnConnector {

    @Override
    public void check(ConnectorSymbol connector, Context context, Findings findings) {
        if (!connector.source().isSender() || !connector.target().isReceiver()) {
            return;
        }
        PortSymbol source = connector.source().port().orElseThrow();
        PortSymbol target = connector.target().port().orElseThrow();
        if (!TypeRules.fits(source.type(), target.type())) {
            findings.report(
                            connector.span(),
                            "'%s' sends %s, but '%s' receives %s; make the types equal, or put a"
                                    + " component in between",
                            connector.source().text(),
                            Wording.distinct(source.type(), target.type()),
                            connector.target().text(),
                            Wording.distinct(target.type(), source.type()))
                    .related(source.nameSpan(), "the sending port")
                    .related(target.nameSpan(), "the receiving port");
        }
    }
}
