package arcomat.check.behaviour.item;

import arcomat.check.law.Check;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.symbols.bodies.ItemSymbol;
import arcomat.symbols.bodies.ItemSymbol.Side;
import arcomat.symbols.expressions.ItemValue;
import arcomat.symbols.expressions.TypedExpression;
import arcomat.tree.AutomatonElement.Transition;
import arcomat.tree.Block;
import arcomat.tree.Expression;
import arcomat.tree.Expression.BinaryOperator;
import arcomat.tree.Expression.UnaryOperator;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * A condition that stands in the braces of a transition, where a message is expected.
 *
 * @param message the part of the item that is the condition
 */
record MisplacedCondition(ItemSymbol item, ItemValue.Single message) {
    private static final Set<BinaryOperator> CONDITIONS =
            EnumSet.range(BinaryOperator.LESS, BinaryOperator.EQUIVALENT);

    /** Operators that bind less than {@code &&}. */
    private static final Set<BinaryOperator> LOOSE =
            EnumSet.of(BinaryOperator.OR, BinaryOperator.IMPLIES, BinaryOperator.EQUIVALENT);

    /**
     * The first condition among the messages of an item: a comparison or connective that is not in
     * parentheses and reads an input port; without a name, one that reads a variable does as well.
     */
    static Optional<MisplacedCondition> in(ItemSymbol item) {
        return Items.parts(item.value()).stream()
                .filter(ItemValue.Single.class::isInstance)
                .map(part -> new MisplacedCondition(item, (ItemValue.Single) part))
                .filter(MisplacedCondition::isMisplaced)
                .findFirst();
    }

    private boolean isMisplaced() {
        return !isInParentheses() && isCondition(expression()) && readsWhatChanges();
    }

    private Expression expression() {
        return message.expression().expression().node();
    }

    /** Parentheses leave no node, but they belong to the message. */
    private boolean isInParentheses() {
        return !message.node().span().equals(expression().span());
    }

    private boolean isCondition(Expression expression) {
        return isComparison(expression) || isQuestion(expression) || isNegation(expression);
    }

    private static boolean isComparison(Expression expression) {
        return expression instanceof Expression.Binary binary
                && CONDITIONS.contains(binary.operator());
    }

    private static boolean isQuestion(Expression expression) {
        return expression instanceof Expression.Membership
                || expression instanceof Expression.Absence;
    }

    private boolean isNegation(Expression expression) {
        return expression instanceof Expression.Unary unary
                && !item.hasName()
                && unary.operator() == UnaryOperator.NOT
                && isCondition(unary.operand());
    }

    private boolean readsWhatChanges() {
        boolean[] reads = {!item.hasName() && !message.expression().variablesRead().isEmpty()};
        message.expression().expression().walk(part -> reads[0] |= readsPort(part));
        return reads[0];
    }

    private static boolean readsPort(TypedExpression part) {
        return part instanceof TypedExpression.Absence
                || part instanceof TypedExpression.PortRead read && read.port().isInput();
    }

    /** What is read as the message. */
    String messageText() {
        return message.node().span().text();
    }

    /** The condition that is meant. */
    String text() {
        return item.node()
                .name()
                .filter(name -> item.side() == Side.INPUT)
                .map(name -> name.text() + " == " + messageText())
                .orElseGet(this::messageText);
    }

    /**
     * Moves the condition into the guard, where that is what is meant: not where events drive the
     * automaton, since a guard awaits no message.
     */
    Optional<Fix> fix(Check.Context context) {
        boolean byEvents = context.automaton().filter(Items::isEventDriven).isPresent();
        return context.transition().filter(any -> !byEvents).flatMap(each -> fix(each.node()));
    }

    private Optional<Fix> fix(Transition transition) {
        if (item.side() == Side.INPUT) {
            return item.node().value() instanceof Block.Single
                    ? transition.input().map(block -> moved(transition, block))
                    : Optional.empty();
        }
        return item.side() == Side.OUTPUT && item.hasName() ? split(transition) : Optional.empty();
    }

    private Fix moved(Transition transition, Block block) {
        String condition = text();
        Optional<Expression> guard = transition.guard().map(each -> each.condition());
        List<TextEdit> edits = new ArrayList<>();
        if (block.items().size() == 1 && guard.isEmpty()) {
            edits.add(new TextEdit(block.span(), "[" + condition + "]"));
        } else {
            edits.add(
                    guard.isEmpty()
                            ? guarded(transition, condition)
                            : guarded(transition, operand(condition, expression())));
            edits.add(new TextEdit(withSeparator(transition, block), ""));
        }
        return fix(condition, edits);
    }

    private static Fix fix(String condition, List<TextEdit> edits) {
        return new Fix("Move '" + condition + "' into the guard", edits);
    }

    /** The item with what separates it from a neighbour; if it is alone, the whole block. */
    private Span withSeparator(Transition transition, Block block) {
        List<Block.Item> items = block.items();
        Span own = item.node().span();
        int place = items.indexOf(item.node());
        if (items.size() == 1) {
            int guard = transition.guard().orElseThrow().span().end();
            return new Span(own.file(), guard, block.span().end());
        }
        return place + 1 < items.size()
                ? new Span(own.file(), own.start(), items.get(place + 1).span().start())
                : new Span(own.file(), items.get(place - 1).span().end(), own.end());
    }

    /** The guard with one more condition, or a new guard behind the states. */
    private static TextEdit guarded(Transition transition, String condition) {
        if (transition.guard().isPresent()) {
            Expression old = transition.guard().get().condition();
            return new TextEdit(old.span(), operand(old.span().text(), old) + " && " + condition);
        }
        Span states = transition.target().orElse(transition.source()).span();
        Span behind = new Span(states.file(), states.end(), states.end());
        return new TextEdit(behind, " [" + condition + "]");
    }

    private static String operand(String text, Expression expression) {
        boolean loose =
                expression instanceof Expression.Binary binary && LOOSE.contains(binary.operator())
                        || expression instanceof Expression.Conditional;
        return loose ? "(" + text + ")" : text;
    }

    /**
     * {@code speed = 2 && dark}: the first operand is the message, the others are the condition.
     */
    private Optional<Fix> split(Transition transition) {
        Expression first = expression();
        while (first instanceof Expression.Binary both && both.operator() == BinaryOperator.AND) {
            first = both.left();
        }
        if (first == expression() || isCondition(first)) {
            return Optional.empty();
        }
        int behindFirst = first.span().end() - message.node().span().start();
        int operator = messageText().indexOf("&&", behindFirst);
        String condition = messageText().substring(operator + 2).strip();
        Span value = message.node().span();
        Span rest = new Span(value.file(), first.span().end(), value.end());
        return Optional.of(
                fix(condition, List.of(guarded(transition, condition), new TextEdit(rest, ""))));
    }
}
