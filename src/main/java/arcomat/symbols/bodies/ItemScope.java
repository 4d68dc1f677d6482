package arcomat.symbols.bodies;

import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.ValueSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.symbols.names.UnknownType;
import arcomat.tree.Block;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Resolves the items of an automaton's blocks. */
final class ItemScope {
    private final List<PortSymbol> ports;
    private final List<VariableSymbol> variables;
    private final ValueScope values;

    ItemScope(List<PortSymbol> ports, List<VariableSymbol> variables, ValueScope values) {
        this.ports = ports;
        this.variables = variables;
        this.values = values;
    }

    ValueScope values() {
        return values;
    }

    /** With one more name; no item without a name is about it. */
    ItemScope with(VariableSymbol local) {
        return new ItemScope(ports, variables, values.with(List.of(local)));
    }

    /** Calls and increments are not among them. */
    List<ItemSymbol> items(Optional<Block> block, Side side) {
        List<ItemSymbol> items = new ArrayList<>();
        for (Block.Item item : block.map(Block::items).orElse(List.of())) {
            if (item instanceof Block.Message message) {
                items.add(item(message, side));
            }
        }
        return List.copyOf(items);
    }

    ItemSymbol item(Block.Message node, Side side) {
        if (node.name().isPresent()) {
            Optional<ValueSymbol> target = values.value(node.name().get().text());
            TypeSymbol expected = target.map(ValueSymbol::type).orElse(UnknownType.UNKNOWN);
            ItemValue value = valueFor(node.value(), target.isPresent(), expected);
            return new ItemSymbol(node, side, Resolution.of(target), value);
        }
        return unnamed(node, side);
    }

    /** Where the name is unknown, a bare constant cannot be judged: problems would be echoes. */
    private ItemValue valueFor(Block.Value node, boolean judged, TypeSymbol expected) {
        ItemValue value = ItemValue.of(node, values, expected);
        return judged && !expected.isErroneous() ? value : value.withoutUnknownNames();
    }

    private ItemSymbol unnamed(Block.Message node, Side side) {
        List<ValueSymbol> exact = new ArrayList<>();
        List<ValueSymbol> wide = new ArrayList<>();
        for (ValueSymbol candidate : candidates(node.value(), side)) {
            ItemValue value = ItemValue.of(node.value(), values, candidate.type());
            if (fits(value, candidate.type())) {
                wide.add(candidate);
                if (isExact(value, candidate.type())) {
                    exact.add(candidate);
                }
            }
        }
        List<ValueSymbol> chosen = exact.isEmpty() ? wide : exact;
        TypeSymbol expected = chosen.isEmpty() ? UnknownType.UNKNOWN : chosen.get(0).type();
        ItemValue value = ItemValue.of(node.value(), values, expected);
        if (chosen.isEmpty() && hasProblemOfItsOwn(value)) {
            return new ItemSymbol(node, side, Resolution.excused(), value);
        }
        ItemValue reported = chosen.isEmpty() ? value.withoutUnknownNames() : value;
        return new ItemSymbol(node, side, resolution(chosen), reported);
    }

    private Resolution<ValueSymbol> resolution(List<ValueSymbol> chosen) {
        boolean excused = chosen.isEmpty() && ports.stream().anyMatch(p -> p.type().isErroneous());
        return excused ? Resolution.excused() : Resolution.of(chosen);
    }

    /** Without a name, {@code --} and {@code ?} can only mean a port. */
    private List<ValueSymbol> candidates(Block.Value value, Side side) {
        boolean input = side == Side.INPUT;
        List<ValueSymbol> all = new ArrayList<>();
        ports.stream()
                .filter(port -> port.isInput() == input && !port.type().isErroneous())
                .forEach(all::add);
        if (!(value instanceof Block.NoMessage) && !(value instanceof Block.AnyMessage)) {
            all.addAll(variables);
        }
        return all;
    }

    private static boolean fits(ItemValue value, TypeSymbol type) {
        return value.expressions().stream()
                .allMatch(
                        e ->
                                e.problems().isEmpty()
                                        && !e.type().isErroneous()
                                        && e.isAssignableTo(type));
    }

    private static boolean isExact(ItemValue value, TypeSymbol type) {
        return value.expressions().stream().allMatch(e -> e.type().base().equals(type.base()));
    }

    /** Whether the value is wrong wherever it goes: then its problem is reported, not the name. */
    private static boolean hasProblemOfItsOwn(ItemValue value) {
        return value.expressions().stream()
                .anyMatch(e -> !e.problems().isEmpty() && !e.isUnknownBareName());
    }
}
