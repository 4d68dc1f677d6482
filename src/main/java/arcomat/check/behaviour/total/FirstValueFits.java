package arcomat.check.behaviour.total;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.WrittenMessage;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Name;

/** ARC0340: what a port holds from the beginning is one of its messages, and it can hold some. */
public final class FirstValueFits implements Check.OnPort {

    @Override
    public void check(PortSymbol port, Context context, Findings findings) {
        port.first().ifPresent(first -> check(first, port, context, findings));
    }

    private static void check(Name first, PortSymbol port, Context context, Findings findings) {
        TypeSymbol type = port.type();
        if (!port.isInput() || context.component().filter(FirstValueFits::holds).isEmpty()) {
            findings.report(
                    first,
                    "port '%s' holds nothing itself: only inputs of untimed components without"
                            + " parts do; write the value where it is held",
                    port.name());
        } else if (!type.isErroneous() && WrittenMessage.read(first.text(), type).isEmpty()) {
            findings.report(
                    first,
                    "port '%s' carries %s, and '%s' is no message of that type",
                    port.name(),
                    type.text(),
                    first);
        }
    }

    private static boolean holds(ComponentSymbol component) {
        return component.isEventDriven() && !component.isDecomposed();
    }
}
