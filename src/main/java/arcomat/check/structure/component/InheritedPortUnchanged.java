package arcomat.check.structure.component;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0114: a port that is inherited and declared again keeps direction and type. (Hab16 R12) */
public final class InheritedPortUnchanged implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        if (component.lineage().size() == 1) {
            return;
        }
        Map<String, PortSymbol> inherited = new HashMap<>();
        List<PortSymbol> all = component.ports();
        for (PortSymbol port :
                all.subList(0, all.size() - component.signature().ownPorts().size())) {
            inherited.put(port.name(), port);
        }
        for (PortSymbol port : component.signature().ownPorts()) {
            PortSymbol old = inherited.get(port.name());
            if (old != null) {
                compare(port, old, findings);
            }
        }
    }

    private static void compare(PortSymbol port, PortSymbol old, Findings findings) {
        boolean sameType =
                port.type().isErroneous()
                        || old.type().isErroneous()
                        || port.type().equals(old.type());
        if (port.direction() == old.direction() && sameType) {
            return;
        }
        findings.report(
                        port.nameSpan(),
                        "port '%s' is inherited as %s, but declared as %s; give this one another"
                                + " name",
                        port.name(),
                        text(old, port),
                        text(port, old))
                .related(old.nameSpan(), "the inherited port");
    }

    private static String text(PortSymbol port, PortSymbol other) {
        return (port.isInput() ? "'in " : "'out ")
                + Wording.distinct(port.type(), other.type())
                + "'";
    }
}
