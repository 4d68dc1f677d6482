package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** ARC0320: a transition of an untimed component names exactly one event. */
public final class SingleEvent implements Check.OnTransition {

    /** Items that do not resolve have findings; what they would be is not known. */
    @Override
    public void check(TransitionSymbol transition, Context context, Findings findings) {
        if (!Items.isEventDriven(context.automaton().orElseThrow())) {
            return;
        }
        List<String> events = new ArrayList<>();
        for (ItemSymbol item : transition.input()) {
            Optional<PortSymbol> port = Items.port(item);
            if (item.target().found().isEmpty() || !Items.isOnItsSide(item)) {
                return;
            }
            if (port.isPresent() && !port.get().isLatched() && !Items.isSilence(item.value())) {
                events.add(port.get().name());
            }
        }
        if (events.size() != 1) {
            report(transition, events, findings);
        }
    }

    private static void report(
            TransitionSymbol transition, List<String> events, Findings findings) {
        Optional<Block> input = transition.node().input();
        Span place = input.<Node>map(block -> block).orElse(transition.node()).span();
        findings.report(
                place,
                events.isEmpty()
                        ? "an untimed component does nothing without an event; name the message"
                                + " that triggers this"
                        : "an untimed component handles one event at a time, but this waits for "
                                + Wording.quoted(events)
                                + " at once; write one for each, or mark a port whose last value is"
                                + " meant with <<state>>");
    }
}
