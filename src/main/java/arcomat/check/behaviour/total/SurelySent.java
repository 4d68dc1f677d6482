package arcomat.check.behaviour.total;

import arcomat.check.behaviour.item.Items;
import arcomat.symbols.bodies.ActionSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.PortSymbol;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * The ports that carry a message behind some statements, whichever way is taken.
 *
 * @param before those in front of them
 */
record SurelySent(Set<PortSymbol> before) implements ActionSymbol.Cases<Set<PortSymbol>> {

    /** Of a block, whose items happen together. */
    static Set<PortSymbol> atOnce(List<ItemSymbol> items) {
        Set<PortSymbol> sent = new HashSet<>();
        for (ItemSymbol item : items) {
            if (!Items.isSilence(item.value())) {
                Items.port(item).ifPresent(sent::add);
            }
        }
        return sent;
    }

    @Override
    public Set<PortSymbol> sequence(ActionSymbol.Sequence sequence) {
        Set<PortSymbol> sent = before;
        for (ActionSymbol each : sequence.actions()) {
            sent = each.match(new SurelySent(sent));
        }
        return sent;
    }

    @Override
    public Set<PortSymbol> assign(ActionSymbol.Assign assign) {
        Set<PortSymbol> sent = new HashSet<>(before);
        boolean silence = Items.isSilence(assign.item().value());
        Items.port(assign.item()).ifPresent(silence ? sent::remove : sent::add);
        return sent;
    }

    @Override
    public Set<PortSymbol> choose(ActionSymbol.Choose choice) {
        Set<PortSymbol> sent = new HashSet<>(choice.then().match(this));
        sent.retainAll(choice.otherwise().map(each -> each.match(this)).orElse(before));
        return sent;
    }

    @Override
    public Set<PortSymbol> declare(ActionSymbol.Declare declare) {
        return before;
    }
}
