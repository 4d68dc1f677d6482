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
    /** How a port is asked. */
    private sealed interface Wish {}

    private record Silence() implements Wish {}

    private record Message() implements Wish {}

    private record OneOf(Set<Object> values) implements Wish {}

    private final Map<String, Wish> wishes = new HashMap<>();
    private boolean isPossible = true;

    private SureTrigger() {}

    /** Empty where a guard or a value would have to be looked at more closely. */
    static Optional<SureTrigger> of(TransitionSymbol transition) {
        SureTrigger trigger = new SureTrigger();
        AutomatonElement.Transition node = transition.node();
        if (transition.guard().isPresent() || !areMessages(node.input())) {
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
            return Optional.of(new Silence());
        }
        if (value.node() instanceof Block.AnyMessage) {
            return Optional.of(new Message());
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
        return values.isEmpty() || isSequence ? Optional.empty() : Optional.of(new OneOf(values));
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
                                    add(read.port().name(), new Message());
                                }
                            });
        }
    }

    private void add(String port, Wish wish) {
        Wish known = wishes.get(port);
        if (known == null || known instanceof Message && !(wish instanceof Silence)) {
            wishes.put(port, wish);
        } else if (known instanceof OneOf one && wish instanceof OneOf other) {
            Set<Object> both = new HashSet<>(one.values);
            both.retainAll(other.values);
            wishes.put(port, new OneOf(both));
            isPossible &= !both.isEmpty();
        } else {
            isPossible &= known.getClass() == wish.getClass() || known instanceof OneOf;
            isPossible &= !(known instanceof OneOf && wish instanceof Silence);
        }
    }

    /** Whether one letter enables both. */
    boolean meets(SureTrigger other) {
        SureTrigger both = new SureTrigger();
        wishes.forEach(both::add);
        other.wishes.forEach(both::add);
        return both.isPossible;
    }
}
