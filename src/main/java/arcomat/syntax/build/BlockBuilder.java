package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.BlockContext;
import arcomat.syntax.antlr.ArcomatParser.CallItemContext;
import arcomat.syntax.antlr.ArcomatParser.IncrementItemContext;
import arcomat.syntax.antlr.ArcomatParser.MessageItemContext;
import arcomat.syntax.antlr.ArcomatParser.UnnamedItemContext;
import arcomat.tree.Block;
import arcomat.tree.Block.Call;
import arcomat.tree.Block.Increment;
import arcomat.tree.Block.Item;
import arcomat.tree.Block.Message;

import java.util.Optional;

/** Blocks and their items. */
final class BlockBuilder extends TreeBuilder<Item> {
    private final Phrases phrases;

    BlockBuilder(Phrases phrases) {
        super(phrases.texts);
        this.phrases = phrases;
    }

    Optional<Block> block(BlockContext context) {
        return context == null
                ? Optional.empty()
                : Optional.of(new Block(span(context), buildAll(context.item())));
    }

    @Override
    public Item visitMessageItem(MessageItemContext context) {
        return new Message(
                span(context),
                phrases.names.buildOptional(context.name()),
                phrases.values.build(context.value()));
    }

    @Override
    public Item visitUnnamedItem(UnnamedItemContext context) {
        return new Message(span(context), Optional.empty(), phrases.values.build(context.value()));
    }

    @Override
    public Item visitCallItem(CallItemContext context) {
        return new Call(span(context), phrases.expressions.build(context.expression()));
    }

    @Override
    public Item visitIncrementItem(IncrementItemContext context) {
        boolean up = context.operator.getText().equals("++");
        return new Increment(
                span(context), phrases.qualifiedNames.build(context.qualifiedName()), up);
    }
}
