package arcomat.check.structure.connector;

import arcomat.check.facts.OpenPorts;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Profile;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/**
 * ARC0109: the ports of a part are connected. Of a total input, and before code is made of every
 * input, other laws take care. (Hab16 CV6)
 */
public final class SubcomponentPortConnected implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        OpenPorts open = OpenPorts.in(component);
        for (InstanceSymbol instance : component.ownInstances()) {
            check(instance, open.of(instance), context, findings);
        }
    }

    private static void check(
            InstanceSymbol instance, List<PortSymbol> open, Context context, Findings findings) {
        List<String> outputs = OpenPorts.names(open, PortSymbol::isOutput);
        if (context.profile() == Profile.REQUIREMENTS) {
            List<String> inputs = OpenPorts.names(open, p -> p.isInput() && !p.isTotal());
            report("input", inputs, "receives nothing", "receive nothing", instance, findings);
        }
        report("output", outputs, "is read by nobody", "are read by nobody", instance, findings);
    }

    private static void report(
            String kind,
            List<String> ports,
            String one,
            String several,
            InstanceSymbol instance,
            Findings findings) {
        if (!ports.isEmpty()) {
            boolean single = ports.size() == 1;
            findings.report(
                    instance.nameSpan(),
                    kind
                            + (single ? " " : "s ")
                            + Wording.quoted(ports)
                            + " of '"
                            + instance.name()
                            + "' "
                            + (single ? one : several)
                            + "; connect "
                            + (single ? "it" : "them"));
        }
    }
}
