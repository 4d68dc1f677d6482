package arcomat.check;

import arcomat.symbols.AutomatonSymbol;
import arcomat.symbols.ComponentSymbol;
import arcomat.symbols.ItemSymbol;
import arcomat.symbols.ItemValue;
import arcomat.symbols.PortSymbol;
import arcomat.symbols.ValueSymbol;
import arcomat.symbols.VariableSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Questions about items that several laws ask. */
final class Items {
    private Items() {}

    static Optional<PortSymbol> port(ItemSymbol item) {
        return item.target()
                .found()
                .filter(PortSymbol.class::isInstance)
                .map(PortSymbol.class::cast);
    }

    static Optional<VariableSymbol> variable(ItemSymbol item) {
        return item.target()
                .found()
                .filter(VariableSymbol.class::isInstance)
                .map(VariableSymbol.class::cast);
    }

    /** Whether an item stands on a side where its target may stand: else that is the finding. */
    static boolean isOnItsSide(ItemSymbol item) {
        return item.target().found().filter(target -> mayStand(target, item.side())).isPresent();
    }

    private static boolean mayStand(ValueSymbol target, ItemSymbol.Side side) {
        boolean input = side == ItemSymbol.Side.INPUT;
        if (target instanceof PortSymbol port) {
            return port.isInput() == input;
        }
        return target instanceof VariableSymbol variable
                && (input || variable.kind() == VariableSymbol.Kind.AUTOMATON);
    }

    /** The name of an item, or the whole item where the name is left out. */
    static Node place(ItemSymbol item) {
        return item.node().name().<Node>map(name -> name).orElse(item.node());
    }

    /** A value and, for alternatives, the values in it. */
    static List<ItemValue> parts(ItemValue value) {
        List<ItemValue> parts = new ArrayList<>();
        parts.add(value);
        if (value instanceof ItemValue.Alternatives alternatives) {
            alternatives.values().forEach(each -> parts.addAll(parts(each)));
        }
        return parts;
    }

    static boolean isSilence(ItemValue value) {
        return value.node() instanceof Block.NoMessage;
    }

    /** What the target is called in messages: "port 'cmd'". */
    static String words(ValueSymbol target) {
        if (target instanceof PortSymbol port) {
            return (port.isInput() ? "input port '" : "output port '") + port.name() + "'";
        }
        if (target instanceof VariableSymbol variable) {
            return variable.kind() == VariableSymbol.Kind.AUTOMATON
                    ? "variable '" + variable.name() + "'"
                    : "component variable '" + variable.name() + "'";
        }
        return "parameter '" + target.name() + "'";
    }

    /** Names that an item of a side may have, for suggestions. */
    static List<String> candidates(AutomatonSymbol automaton, ItemSymbol.Side side) {
        List<String> names = new ArrayList<>();
        for (PortSymbol port : automaton.ports()) {
            if (port.isInput() == (side == ItemSymbol.Side.INPUT)) {
                names.add(port.name());
            }
        }
        automaton.variables().forEach(variable -> names.add(variable.name()));
        return names;
    }

    static boolean isEventDriven(AutomatonSymbol automaton) {
        return automaton.component().filter(ComponentSymbol::isEventDriven).isPresent();
    }

    /** Whether an automaton is a requirement on a composition: then it never runs itself. */
    static boolean isRequirement(AutomatonSymbol automaton) {
        return automaton.component().filter(ComponentSymbol::isDecomposed).isPresent();
    }
}
