package arcomat.check.structure.connector;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.Delays.DelayCycle;

import java.util.List;

/** ARC0124: in each circle of time-synchronous messages some port is delayed. (Hab16 CG1) */
public final class DelayInCycle implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.isEventDriven()) {
            return;
        }
        for (DelayCycle cycle : context.workspace().delays().cycles(component)) {
            report(cycle, findings);
        }
    }

    private static void report(DelayCycle cycle, Findings findings) {
        List<ConnectorSymbol> connectors = cycle.connectors();
        findings.report(
                connectors.get(0).span(),
                "messages run in a circle without delay: %s; let one of these parts react a slice"
                        + " later",
                cycle.text());
        for (ConnectorSymbol connector : connectors.subList(1, connectors.size())) {
            findings.related(
                    connector.span(),
                    "'" + connector.source().text() + "' to '" + connector.target().text() + "'");
        }
    }
}
