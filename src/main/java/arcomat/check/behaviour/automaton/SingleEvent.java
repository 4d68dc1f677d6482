package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Wording;
import arcomat.check.law.Check;
import arcomat.source.Span;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TableSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** ARC0320: a transition, or a row, of an untimed component names exactly one event. */
public final class SingleEvent implements Check.OnTransition, Check.OnTable {

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

    @Override
    public void check(TableSymbol table, Context context, Findings findings) {
        if (table.component().signature().timing().eventDriven()) {
            table.rows().forEach(row -> check(row, table.inputs(), findings));
        }
    }

    /** Rows of another width, and columns that are no ports, have findings. */
    private static void check(
            TableSymbol.Row row, List<TableSymbol.Column> columns, Findings findings) {
        if (row.inputs().size() != columns.size()) {
            return;
        }
        List<String> events = new ArrayList<>();
        for (int i = 0; i < columns.size(); i++) {
            Optional<PortSymbol> port = columns.get(i).port();
            if (port.isEmpty()) {
                return;
            }
            if (!port.get().isLatched() && asksForMessage(row.inputs().get(i))) {
                events.add(port.get().name());
            }
        }
        if (events.size() != 1) {
            report(row, events, findings);
        }
    }

    private static boolean asksForMessage(ItemValue cell) {
        return !Items.isSilence(cell) && !(cell.node() instanceof Block.DontCare);
    }

    private static void report(TableSymbol.Row row, List<String> events, Findings findings) {
        findings.report(
                row.node(),
                events.isEmpty()
                        ? "a row of an untimed component waits for an event; name the message in"
                                + " one of its input cells"
                        : "an untimed component handles one event at a time, but this row waits"
                                + " for "
                                + Wording.quoted(events)
                                + " at once; write a row for each");
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
