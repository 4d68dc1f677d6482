package arcomat.symbols.bodies;

import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.names.BuiltinType;
import arcomat.symbols.names.Lazy;
import arcomat.tree.AutomatonElement;

import java.util.List;
import java.util.Optional;

/** A transition with resolved states, guard and items. */
public final class TransitionSymbol {
    private final AutomatonSymbol automaton;
    private final AutomatonElement.Transition node;
    private final Lazy<Optional<Typed>> guard = new Lazy<>(this::typeGuard);
    private final Lazy<List<ItemSymbol>> input = new Lazy<>(() -> items(Side.INPUT));
    private final Lazy<List<ItemSymbol>> output = new Lazy<>(() -> items(Side.OUTPUT));
    private final Lazy<Optional<ActionSymbol>> actions = new Lazy<>(this::typeActions);

    TransitionSymbol(AutomatonSymbol automaton, AutomatonElement.Transition node) {
        this.automaton = automaton;
        this.node = node;
    }

    public AutomatonElement.Transition node() {
        return node;
    }

    /** Empty where no such state is declared. */
    public Optional<StateSymbol> source() {
        return automaton.state(node.source().text());
    }

    /** Empty where no such state is declared; the source where no target is written. */
    public Optional<StateSymbol> target() {
        return automaton.state(node.target().orElse(node.source()).text());
    }

    public Optional<Typed> guard() {
        return guard.get();
    }

    /** The messages and conditions of the input block; calls and increments are not among them. */
    public List<ItemSymbol> input() {
        return input.get();
    }

    /** The messages and assignments of the output block, or all those of its statements. */
    public List<ItemSymbol> output() {
        return output.get();
    }

    /** What happens one after the other, where the transition has statements. */
    public Optional<ActionSymbol> actions() {
        return actions.get();
    }

    private Optional<ActionSymbol> typeActions() {
        return automaton.actions(node.actions(), Side.OUTPUT);
    }

    private Optional<Typed> typeGuard() {
        return node.guard()
                .map(
                        g ->
                                ExpressionTyping.type(
                                        g.condition(), automaton.scope(), BuiltinType.BOOLEAN));
    }

    private List<ItemSymbol> items(Side side) {
        if (side == Side.OUTPUT && actions().isPresent()) {
            return actions().get().items();
        }
        return automaton.itemScope().items(side == Side.INPUT ? node.input() : node.output(), side);
    }
}
