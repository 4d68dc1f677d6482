package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatBaseVisitor;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Builds one family of nodes.
 *
 * @param <T> the root of the family
 */
abstract class TreeBuilder<T> extends ArcomatBaseVisitor<T> {
    protected final SharedTexts texts;

    protected TreeBuilder(SharedTexts texts) {
        this.texts = texts;
    }

    final T build(ParserRuleContext context) {
        return context.accept(this);
    }

    final Optional<T> buildOptional(ParserRuleContext context) {
        return context == null ? Optional.empty() : Optional.of(context.accept(this));
    }

    final List<T> buildAll(List<? extends ParserRuleContext> contexts) {
        if (contexts.isEmpty()) {
            return List.of();
        }
        List<T> nodes = new ArrayList<>(contexts.size());
        for (ParserRuleContext context : contexts) {
            nodes.add(context.accept(this));
        }
        return nodes;
    }

    protected final Span span(ParserRuleContext context) {
        return span(context.start, context.stop);
    }

    protected final Span span(Token first, Token last) {
        return texts.span(first.getStartIndex(), last.getStopIndex() + 1);
    }

    protected final Span span(Token token) {
        return span(token, token);
    }
}
