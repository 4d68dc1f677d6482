package arcomat.check.structure.connector;

import arcomat.check.facts.Connections;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;
import java.util.Set;

/** ARC0108: a decomposed component passes on what comes in, and gets what goes out. (Hab16 CV5) */
public final class OwnPortConnected implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (!component.isDecomposed() || Connections.areUnclear(component)) {
            return;
        }
        Set<String> used = Connections.usedKeys(component);
        for (PortSymbol port : portsToCheck(component)) {
            if (!used.contains(port.name())) {
                findings.report(
                        component.signature().ownPorts().contains(port)
                                ? port.nameSpan()
                                : component.nameSpan(),
                        port.isInput()
                                ? "input '" + port.name() + "' leads to no part; connect it"
                                : "output '" + port.name() + "' comes from no part; connect it");
            }
        }
    }

    /** Inherited ports are looked at where the first parts come in. */
    private static List<PortSymbol> portsToCheck(ComponentSymbol component) {
        List<ComponentSymbol> lineage = component.lineage();
        boolean addsFirstParts = lineage.size() == 1 || !lineage.get(1).isDecomposed();
        return addsFirstParts ? component.ports() : component.signature().ownPorts();
    }
}
