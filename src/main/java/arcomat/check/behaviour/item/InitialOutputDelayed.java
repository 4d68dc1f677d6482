package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;

/** ARC0321: an initial output is sent on ports with delay 1 only. */
public final class InitialOutputDelayed implements Check.OnItem {

    /** Untimed components have no delays. */
    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        if (item.side() != ItemSymbol.Side.INITIAL
                || Items.isSilence(item.value())
                || Items.isEventDriven(context.automaton().orElseThrow())) {
            return;
        }
        Items.port(item)
                .filter(port -> port.isOutput() && port.delay() == 0)
                .ifPresent(port -> report(item, port, findings));
    }

    private static void report(ItemSymbol item, PortSymbol port, Findings findings) {
        findings.report(
                        item.node(),
                        "output port '%s' has no delay: its first message already answers the first"
                                + " input; drop the initial output or delay the port with <<delay ="
                                + " \"1\">>",
                        port.name())
                .related(port.nameSpan(), "declared here");
    }
}
