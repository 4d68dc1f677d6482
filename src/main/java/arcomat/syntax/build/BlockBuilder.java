package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Block;
import arcomat.tree.Expression;

import java.util.List;

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
    public Block.Item visitItem(ArcomatParser.ItemContext context) {
        if (context.operator != null) {
            return increment(context);
        }
        return context.expression() == null
                ? message(context)
                : new Block.Call(span(context), phrases.expressions.build(context.expression()));
    }

    private Block.Item message(ArcomatParser.ItemContext context) {
        return new Block.Message(
                span(context), optional(context.place(), phrases::place), value(context.value()));
    }

    /** Several are alternatives, as the tools of 2016 wrote them: {@code a | b}. */
    private Block.Value value(List<ArcomatParser.ValueContext> written) {
        ArcomatParser.ValueContext first = written.get(0);
        return written.size() == 1
                ? values.build(first)
                : new Block.Alternatives(
                        span(first.start, written.get(written.size() - 1).stop),
                        values.buildAll(written));
    }

    private Block.Item increment(ArcomatParser.ItemContext context) {
        boolean up = context.operator.getText().equals("++");
        return new Block.Increment(
                span(context), phrases.qualifiedPlace(context.qualifiedPlace()), up);
    }

    /** Values of items. */
    static final class ValueBuilder extends TreeBuilder<Block.Value> {
        private ValueBuilder(Phrases phrases) {
            super(phrases);
        }

        @Override
        public Block.Value visitValue(ArcomatParser.ValueContext context) {
            ArcomatParser.ExpressionContext expression = context.expression();
            if (expression != null) {
                Expression value = phrases.expressions.build(expression);
                return ExpressionBuilder.isNull(value)
                        ? new Block.NoMessage(span(context))
                        : new Block.Single(span(context), value);
            }
            return context.nothing == null && context.anything == null
                    ? buildSole(context)
                    : mark(context);
        }

        private Block.Value mark(ArcomatParser.ValueContext context) {
            return context.nothing == null
                    ? new Block.AnyMessage(span(context))
                    : new Block.NoMessage(span(context));
        }

        @Override
        public Block.Value visitAlternatives(ArcomatParser.AlternativesContext context) {
            return new Block.Alternatives(span(context), buildAll(context.value()));
        }

        @Override
        public Block.Value visitSequence(ArcomatParser.SequenceContext context) {
            return new Block.Sequence(
                    span(context), phrases.expressions.buildAll(context.expression()));
        }
    }
}
