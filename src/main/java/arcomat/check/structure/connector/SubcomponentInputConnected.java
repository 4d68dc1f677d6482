package arcomat.check.structure.connector;

import arcomat.check.facts.OpenPorts;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.List;

/** ARC0110: before code is made, each input of a part has a sender. */
public final class SubcomponentInputConnected implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        OpenPorts open = OpenPorts.in(component);
        for (InstanceSymbol instance : component.ownInstances()) {
            check(instance, open.of(instance), findings);
        }
    }

    private static void check(InstanceSymbol instance, List<PortSymbol> open, Findings findings) {
        List<String> inputs = OpenPorts.names(open, p -> p.isInput() && !p.isTotal());
        if (!inputs.isEmpty()) {
            boolean single = inputs.size() == 1;
            findings.report(
                    instance.nameSpan(),
                    (single ? "input " : "inputs ")
                            + Wording.quoted(inputs)
                            + " of '"
                            + instance.name()
                            + "' "
                            + (single ? "has" : "have")
                            + " no sender; code needs to know what arrives there");
        }
    }
}
