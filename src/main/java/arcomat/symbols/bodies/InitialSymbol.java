package arcomat.symbols.bodies;

import arcomat.tree.AutomatonElement;
import arcomat.tree.Name;

import java.util.List;
import java.util.Optional;

/**
 * One initial state. A clause that names several states gives several, with the same items.
 *
 * @param node the whole clause
 * @param state empty where no such state is declared
 */
public record InitialSymbol(
        AutomatonElement.Initial node,
        Name name,
        Optional<StateSymbol> state,
        List<ItemSymbol> items) {
    public InitialSymbol {
        items = List.copyOf(items);
    }
}
