package arcomat.check;

import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.ConnectorSymbol;
import arcomat.symbols.PortSymbol;
import arcomat.symbols.TypeRules;

/** ARC0106: what the source of a connector sends, its target can receive. (Hab16 R8) */
final class ConnectorTypes implements Check.OnComponent {

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
