package arcomat.check.structure;

import arcomat.check.facts.Connections;
import arcomat.check.facts.Types;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.TypeRules;

/** ARC0106: what the source of a connector sends, its target can receive. (Hab16 R8) */
public final class ConnectorTypes implements Check.OnComponent {

    @Override
    public Law law() {
        return Law.error("ARC0106");
    }

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        for (ConnectorSymbol connector : Connections.own(component)) {
            if (connector.source().isSender() && connector.target().isReceiver()) {
                check(connector, findings);
            }
        }
    }

    private static void check(ConnectorSymbol connector, Findings findings) {
        PortSymbol source = connector.source().port().orElseThrow();
        PortSymbol target = connector.target().port().orElseThrow();
        if (!TypeRules.fits(source.type(), target.type())) {
            findings.report(
                            connector.span(),
                            "'"
                                    + connector.source().text()
                                    + "' sends "
                                    + Types.distinct(source.type(), target.type())
                                    + ", but '"
                                    + connector.target().text()
                                    + "' receives "
                                    + Types.distinct(target.type(), source.type())
                                    + "; make the types equal, or put a component in between")
                    .related(source.nameSpan(), "the sending port")
                    .related(target.nameSpan(), "the receiving port");
        }
    }
}
