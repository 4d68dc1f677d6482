package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;

/** ARC0314: a list of several messages needs the event-driven profile. (RRW14a S3ts) */
public final class SingleMessagePerSlice implements Check.OnItem {

    /** Lists at variables are the business of {@link NoSequenceOnVariable}. */
    @Override
    public void check(ItemSymbol item, Context context, Findings findings) {
        boolean eventDriven = Items.isEventDriven(context.automaton().orElseThrow());
        boolean input = item.side() == ItemSymbol.Side.INPUT;
        if (Items.variable(item).isPresent() || eventDriven && !input) {
            return;
        }
        for (ItemValue part : Items.parts(item.value())) {
            if (part instanceof ItemValue.Sequence sequence && sequence.expressions().size() > 1) {
                findings.report(sequence.node(), message(sequence, eventDriven));
            }
        }
    }

    private static String message(ItemValue.Sequence sequence, boolean eventDriven) {
        int number = sequence.expressions().size();
        return eventDriven
                ? "an untimed component handles one event at a time, not "
                        + number
                        + "; wait for the first one, and in a state behind it for the next"
                : "a port carries one message in a slice, not "
                        + number
                        + "; use further states, or 'timing untimed;' for the component";
    }
}
