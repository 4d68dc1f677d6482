package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.AlternativesValueContext;
import arcomat.syntax.antlr.ArcomatParser.AnyCellContext;
import arcomat.syntax.antlr.ArcomatParser.AnyMessageValueContext;
import arcomat.syntax.antlr.ArcomatParser.NoMessageValueContext;
import arcomat.syntax.antlr.ArcomatParser.SequenceValueContext;
import arcomat.syntax.antlr.ArcomatParser.SingleValueContext;
import arcomat.syntax.antlr.ArcomatParser.ValueCellContext;
import arcomat.tree.Block.Alternatives;
import arcomat.tree.Block.AnyMessage;
import arcomat.tree.Block.DontCare;
import arcomat.tree.Block.NoMessage;
import arcomat.tree.Block.Sequence;
import arcomat.tree.Block.Single;
import arcomat.tree.Block.Value;

/** Values of items and cells of I/O tables. */
final class ValueBuilder extends TreeBuilder<Value> {
    private final ExpressionBuilder expressions;

    ValueBuilder(SharedTexts texts, ExpressionBuilder expressions) {
        super(texts);
        this.expressions = expressions;
    }

    @Override
    public Value visitAlternativesValue(AlternativesValueContext context) {
        return new Alternatives(span(context), buildAll(context.value()));
    }

    @Override
    public Value visitSequenceValue(SequenceValueContext context) {
        return new Sequence(span(context), expressions.buildAll(context.expression()));
    }

    @Override
    public Value visitNoMessageValue(NoMessageValueContext context) {
        return new NoMessage(span(context));
    }

    @Override
    public Value visitAnyMessageValue(AnyMessageValueContext context) {
        return new AnyMessage(span(context));
    }

    @Override
    public Value visitSingleValue(SingleValueContext context) {
        return new Single(span(context), expressions.build(context.expression()));
    }

    @Override
    public Value visitAnyCell(AnyCellContext context) {
        return new DontCare(span(context));
    }

    @Override
    public Value visitValueCell(ValueCellContext context) {
        return build(context.value());
    }
}
