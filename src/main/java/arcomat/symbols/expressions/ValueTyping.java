package arcomat.symbols.expressions;

import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Block;

/** Types each form of value, for a place of a type. */
record ValueTyping(ValueScope scope, TypeSymbol expected) implements Block.Value.Cases<ItemValue> {
    @Override
    public ItemValue alternatives(Block.Alternatives node) {
        return new ItemValue.Alternatives(
                node, node.values().stream().map(value -> value.match(this)).toList());
    }

    @Override
    public ItemValue sequence(Block.Sequence node) {
        return new ItemValue.Sequence(
                node,
                node.messages().stream()
                        .map(message -> ExpressionTyping.type(message, scope, expected))
                        .toList());
    }

    @Override
    public ItemValue single(Block.Single node) {
        return new ItemValue.Single(
                node, ExpressionTyping.type(node.expression(), scope, expected));
    }

    @Override
    public ItemValue noMessage(Block.NoMessage node) {
        return new ItemValue.Mark(node);
    }

    @Override
    public ItemValue anyMessage(Block.AnyMessage node) {
        return new ItemValue.Mark(node);
    }
}
