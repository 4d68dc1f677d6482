package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.check.law.Context;
import arcomat.check.law.Findings;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.InitialSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ValueSymbol;

import java.util.List;

/** ARC0310: a block has one item for each port and variable. (RRW14a S3ts) */
public final class ItemOncePerBlock implements Check.OnAutomaton {

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
        Duplicates.report(
                items.stream().filter(item -> item.target().isFound()).toList(),
                item -> target(item).name(),
                (item, first) ->
                        findings.report(
                                        Items.place(item),
                                        "this block names %s twice%s; keep one of the two",
                                        Items.words(target(item)),
                                        item.hasName() ? "" : ", here by the type of the message")
                                .related(Items.place(first), "the other one"));
    }

    private static ValueSymbol target(ItemSymbol item) {
        return item.target().found().orElseThrow();
    }
}
