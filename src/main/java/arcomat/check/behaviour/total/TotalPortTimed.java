package arcomat.check.behaviour.total;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Stereotype;

/** ARC0339: only a component that works slice by slice has ports that speak in every slice. */
public final class TotalPortTimed implements Check.OnPort {

    @Override
    public void check(PortSymbol port, Context context, Findings findings) {
        if (context.component().filter(ComponentSymbol::isEventDriven).isEmpty()) {
            return;
        }
        Stereotype.find(port.stereotypes(), "total")
                .ifPresent(
                        total ->
                                findings.report(
                                        total,
                                        "port '%s' cannot carry a message in every slice: an"
                                            + " untimed component knows no slices; remove 'total'",
                                        port.name()));
    }
}
