package arcomat.check.behaviour.automaton;

import arcomat.check.behaviour.item.Items;
import arcomat.check.facts.Duplicates;
import arcomat.check.law.Check;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.tree.Block;

import java.util.List;

/** ARC0310: a block has one item for each port and variable. (RRW14a S3ts) */
public final class ItemOncePerBlock implements Check.OnBlock {

    @Override
    public void check(Block block, List<ItemSymbol> items, Context context, Findings findings) {
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
