package arcomat.check.behaviour.automaton;

import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.ConstantFolding;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.Typed;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Block;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Letters that are sure to enable a transition: port by port some message, none, or one of a few.
 * Ports that are not named may carry anything.
 */
final class SureTrigger {
    /**
     * How a port is asked.
     *
     * @param isSilent whether nothing may be there
     * @param values what a message is one of; any if empty
     */
    private record Wish(boolean isSilent, Optional<Set<Object>> values) {
        static final Wish SILENCE = new Wish(true, Optional.empty());
        static final Wish MESSAGE = new Wish(false, Optional.empty());

        static Wish oneOf(Set<Object> values) {
            return new Wish(false, Optional.of(values));
        }

        boolean isPossible() {
            return values.isEmpty() || !values.get().isEmpty();
        }

        Wish and(Wish other) {
            if (isSilent != other.isSilent) {
                return oneOf(Set.of());
            }
            if (values.isEmpty() || other.values.isEmpty()) {
                return values.isEmpty() ? other : this;
            }
            Set<Object> both = new HashSet<>(values.get());
            both.retainAll(other.values.get());
            return oneOf(both);
        }
    }

    private final Map<String, Wish> wishes = new HashMap<>();
    private boolean isPossible = true;

    private SureTrigger() {}

    /** Empty where a guard, a value, or others that come first would have to be looked at. */
    static Optional<SureTrigger> of(TransitionSymbol transition) {
        SureTrigger trigger = new SureTrigger();
        AutomatonElement.Transition node = transition.node();
        if (node.rank() > 0
                || node.turn() > 0
                || transition.guard().isPresent()
                || transition.actions().isPresent()
                || !areMessages(node.input())) {
            return Optional.empty();
        }
        for (ItemSymbol item : transition.input()) {
            Optional<Wish> wish = wish(item.value());
            if (wish.isEmpty()
                    || !(item.target().found().orElse(null) instanceof PortSymbol port)) {
                return Optional.empty();
            }
            trigger.add(port.name(), wish.get());
        }
        transition.output().forEach(trigger::addReads);
        return trigger.isPossible ? Optional.of(trigger) : Optional.empty();
    }

    private static boolean areMessages(Optional<Block> block) {
        return block.stream()
                .flatMap(each -> each.items().stream())
                .allMatch(Block.Message.class::isInstance);
    }

    private static Optional<Wish> wish(ItemValue value) {
        if (value.node() instanceof Block.NoMessage) {
            return Optional.of(Wish.SILENCE);
        }
        if (value.node() instanceof Block.AnyMessage) {
            return Optional.of(Wish.MESSAGE);
        }
        Set<Object> values = new HashSet<>();
        for (Typed each : value.expressions()) {
            Optional<Object> constant = constant(each.expression());
            if (constant.isEmpty()) {
                return Optional.empty();
            }
            values.add(constant.get());
        }
        boolean isSequence = value instanceof ItemValue.Sequence;
        return values.isEmpty() || isSequence ? Optional.empty() : Optional.of(Wish.oneOf(values));
    }

    /** Of a constant that is no real: two reals may be equal and written differently. */
    static Optional<Object> constant(TypedExpression expression) {
        if (expression instanceof TypedExpression.Constant constant) {
            return Optional.of(constant.ordinal());
        }
        if (expression instanceof TypedExpression.Literal literal
                && !(literal.value() instanceof Double)) {
            return Optional.of(literal.value());
        }
        return ConstantFolding.wholeNumber(expression).map(number -> number);
    }

    /** What is sent on or kept has to be there. */
    private void addReads(ItemSymbol item) {
        for (Typed value : item.value().expressions()) {
            value.expression()
                    .walk(
                            part -> {
                                if (part instanceof TypedExpression.PortRead read) {
                                    add(read.port().name(), Wish.MESSAGE);
                                }
                            });
        }
    }

    private void add(String port, Wish wish) {
        isPossible &= wishes.merge(port, wish, Wish::and).isPossible();
    }

    /** Whether one letter enables both. */
    boolean meets(SureTrigger other) {
        SureTrigger both = new SureTrigger();
        wishes.forEach(both::add);
        other.wishes.forEach(both::add);
        return both.isPossible;
    }
}
