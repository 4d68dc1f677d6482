package arcomat.check;

import arcomat.source.Span;
import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ItemSymbol;
import arcomat.symbols.PortSymbol;
import arcomat.symbols.TransitionSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** ARC0320: a transition of an untimed component names exactly one event. */
final class SingleEvent implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0320");
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        if (Items.isEventDriven(automaton)) {
            automaton.transitions().forEach(transition -> check(transition, findings));
        }
    }

    /** Items that do not resolve have findings; what they would be is not known. */
    private static void check(TransitionSymbol transition, Findings findings) {
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
                        ? "a transition of an untimed component waits for an event; name the"
                                + " message that triggers it"
                        : "an untimed component handles one event at a time, but this waits for "
                                + Wording.quoted(events)
                                + " at once; split the transition, or mark a port whose last value"
                                + " is meant with <<state>>");
    }
}
