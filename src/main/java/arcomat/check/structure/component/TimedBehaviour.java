package arcomat.check.structure.component;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.tree.Element;
import arcomat.tree.Element.TimingKind;

/**
 * ARC0146: what has a behaviour does not mix slices and events. The older tools have a time in
 * which a slice may bring several messages on one port; a component without behaviour may say so,
 * since it does nothing here.
 */
public final class TimedBehaviour implements Check.OnComponent {

    @Override
    public void check(ComponentSymbol component, Context context, Findings findings) {
        boolean behaves = !component.automata().isEmpty();
        component.node().elements(Element.Timing.class).stream()
                .filter(clause -> behaves && clause.kind() == TimingKind.TIMED)
                .forEach(
                        clause ->
                                findings.report(
                                        clause,
                                        "in 'timed' a slice may bring several messages on one port,"
                                            + " which no behaviour means here; write 'causalsync'"
                                            + " where one is enough, or 'untimed' where slices say"
                                            + " nothing"));
    }
}
