package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Block;

import java.util.Optional;

/** Blocks and their items. */
final class BlockBuilder extends TreeBuilder<Block.Item> {
    final ValueBuilder values;

    BlockBuilder(Phrases phrases) {
        super(phrases);
        this.values = new ValueBuilder(phrases);
    }

    Block block(ArcomatParser.BlockContext context) {
        return new Block(span(context), buildAll(context.item()));
    }

    @Override
    public Block.Item visitMessageItem(ArcomatParser.MessageItemContext context) {
        return new Block.Message(
                span(context), phrases.optionalName(context.name()), values.build(context.value()));
    }

    @Override
    public Block.Item visitUnnamedItem(ArcomatParser.UnnamedItemContext context) {
        return new Block.Message(span(context), Optional.empty(), values.build(context.value()));
    }

    @Override
    public Block.Item visitCallItem(ArcomatParser.CallItemContext context) {
        return new Block.Call(span(context), phrases.expressions.build(context.expression()));
    }

    @Override
    public Block.Item visitIncrementItem(ArcomatParser.IncrementItemContext context) {
        boolean up = context.operator.getText().equals("++");
        return new Block.Increment(
                span(context), phrases.qualifiedName(context.qualifiedName()), up);
    }

    /** Values of items and cells of I/O tables. */
    static final class ValueBuilder extends TreeBuilder<Block.Value> {
        private ValueBuilder(Phrases phrases) {
            super(phrases);
        }

        @Override
        public Block.Value visitAlternativesValue(ArcomatParser.AlternativesValueContext context) {
            return new Block.Alternatives(span(context), buildAll(context.value()));
        }

        @Override
        public Block.Value visitSequenceValue(ArcomatParser.SequenceValueContext context) {
            return new Block.Sequence(
                    span(context), phrases.expressions.buildAll(context.expression()));
        }

        @Override
        public Block.Value visitNoMessageValue(ArcomatParser.NoMessageValueContext context) {
            return new Block.NoMessage(span(context));
        }

        @Override
        public Block.Value visitAnyMessageValue(ArcomatParser.AnyMessageValueContext context) {
            return new Block.AnyMessage(span(context));
        }

        @Override
        public Block.Value visitSingleValue(ArcomatParser.SingleValueContext context) {
            return new Block.Single(span(context), phrases.expressions.build(context.expression()));
        }

        @Override
        public Block.Value visitAnyCell(ArcomatParser.AnyCellContext context) {
            return new Block.DontCare(span(context));
        }

        @Override
        public Block.Value visitValueCell(ArcomatParser.ValueCellContext context) {
            return build(context.value());
        }
    }
}
