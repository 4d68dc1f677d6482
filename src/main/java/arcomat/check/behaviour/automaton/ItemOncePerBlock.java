package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.check.law.Law;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.InitialSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** ARC0310: a block has one item for each port and variable. (RRW14a S3ts) */
public final class ItemOncePerBlock implements Check.OnAutomaton {

    @Override
    public Law law() {
        return Law.error("ARC0310");
    }

    @Override
    public void check(AutomatonSymbol automaton, Context context, Findings findings) {
        for (InitialSymbol initial : automaton.initials()) {
            check(initial.items(), findings);
        }
        for (TransitionSymbol transition : automaton.transitions()) {
            check(transition.input(), findings);
            check(transition.output(), findings);
        }
    }

    private static void check(List<ItemSymbol> items, Findings findings) {
        if (items.size() < 2) {
            return;
        }
        Map<String, ItemSymbol> seen = new HashMap<>();
        for (ItemSymbol item : items) {
            item.target().found().ifPresent(target -> check(item, target, seen, findings));
        }
    }

    private static void check(
            ItemSymbol item, ValueSymbol target, Map<String, ItemSymbol> seen, Findings findings) {
        ItemSymbol first = seen.putIfAbsent(target.name(), item);
        if (first != null) {
            findings.report(
                            Items.place(item),
                            "this block names "
                                    + Items.words(target)
                                    + " twice"
                                    + (item.hasName() ? "" : ", here by the type of the message")
                                    + "; keep one of the two")
                    .related(Items.place(first), "the other one");
        }
    }
}
