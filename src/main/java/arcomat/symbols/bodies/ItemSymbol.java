package arcomat.symbols.bodies;

import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.tree.Block;

/**
 * An item of a block, {@code name = value}, with what its name means and its typed value.
 *
 * @param target the port, variable or parameter; where the name is left out, the one that the value
 *     fits: unknown if there is none, ambiguous if there are several. Direction and side are for
 *     the checks where a name is written; without a name only fitting sides are candidates.
 */
public record ItemSymbol(
        Block.Message node, Side side, Resolution<ValueSymbol> target, ItemValue value) {
    /** The block an item stands in. */
    public enum Side {
        INPUT,
        OUTPUT,
        /** The output block of an initial state. */
        INITIAL
    }

    public boolean hasName() {
        return node.name().isPresent();
    }
}
