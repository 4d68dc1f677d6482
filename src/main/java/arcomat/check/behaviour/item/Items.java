package arcomat.check.behaviour.item;

import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.tree.Block;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;

/** Questions about items that several laws ask. */
public final class Items {
    private Items() {}

    public static Optional<PortSymbol> port(ItemSymbol item) {
        return target(item, PortSymbol.class);
    }

    static Optional<VariableSymbol> variable(ItemSymbol item) {
        return target(item, VariableSymbol.class);
    }

    private static <T> Optional<T> target(ItemSymbol item, Class<T> kind) {
        return item.target().found().filter(kind::isInstance).map(kind::cast);
    }

    /** Whether an item stands on a side where its target may stand: else that is the finding. */
    public static boolean isOnItsSide(ItemSymbol item) {
        return item.target().found().filter(target -> mayStand(target, item.side())).isPresent();
    }

    private static boolean mayStand(ValueSymbol target, ItemSymbol.Side side) {
        boolean input = side == ItemSymbol.Side.INPUT;
        if (target instanceof PortSymbol port) {
            return port.isInput() == input;
        }
        return target instanceof VariableSymbol;
    }

    /** The name of an item, or the whole item where the name is left out. */
    public static Node place(ItemSymbol item) {
        return item.node().name().<Node>map(name -> name).orElse(item.node());
    }

    /** A value and, for alternatives, the values in it. */
    public static List<ItemValue> parts(ItemValue value) {
        if (!(value instanceof ItemValue.Alternatives alternatives)) {
            return List.of(value);
        }
        List<ItemValue> parts = new ArrayList<>();
        parts.add(value);
        alternatives.values().forEach(each -> parts.addAll(parts(each)));
        return parts;
    }

    /** Shows the value of an item about a variable, and for alternatives the values in it. */
    static void ofVariable(ItemSymbol item, BiConsumer<VariableSymbol, ItemValue> visitor) {
        if (isOnItsSide(item)) {
            variable(item)
                    .ifPresent(v -> parts(item.value()).forEach(part -> visitor.accept(v, part)));
        }
    }

    public static boolean isSilence(ItemValue value) {
        return value.node() instanceof Block.NoMessage;
    }

    /** What the target is called in messages: "port 'cmd'". */
    public static String words(ValueSymbol target) {
        if (target instanceof PortSymbol port) {
            return (port.isInput() ? "input port '" : "output port '") + port.name() + "'";
        }
        if (target instanceof VariableSymbol variable) {
            return kind(variable.kind()) + " '" + variable.name() + "'";
        }
        return "parameter '" + target.name() + "'";
    }

    private static String kind(VariableSymbol.Kind kind) {
        return switch (kind) {
            case AUTOMATON -> "variable";
            case COMPONENT -> "component variable";
            case LOCAL -> "local variable";
            case SUITE -> "field";
        };
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
        automaton
                .component()
                .ifPresent(
                        component ->
                                component
                                        .signature()
                                        .variables()
                                        .forEach(variable -> names.add(variable.name())));
        return names;
    }

    public static boolean isEventDriven(AutomatonSymbol automaton) {
        return automaton.component().filter(ComponentSymbol::isEventDriven).isPresent();
    }

    /** Whether an automaton is a requirement on a composition: then it never runs itself. */
    public static boolean isRequirement(AutomatonSymbol automaton) {
        return automaton.component().filter(ComponentSymbol::isDecomposed).isPresent();
    }
}
