package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatBaseVisitor;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;

/**
 * Builds one family of nodes: a method for each alternative of a production.
 *
 * @param <T> the root of the family
 */
abstract class TreeBuilder<T> extends ArcomatBaseVisitor<T> {
    protected final Phrases phrases;

    protected TreeBuilder(Phrases phrases) {
        this.phrases = phrases;
    }

    final T build(ParserRuleContext context) {
        return context.accept(this);
    }

    /** The node of a production that is one of several others. */
    final T buildSole(ParserRuleContext context) {
        return build((ParserRuleContext) Objects.requireNonNull(context.getChild(0)));
    }

    final List<T> buildAll(List<? extends ParserRuleContext> contexts) {
        return each(contexts, this::build);
    }

    /** The nodes of a row of productions that have one alternative. */
    static <C, N> List<N> each(List<? extends C> contexts, Function<C, ? extends N> build) {
        switch (contexts.size()) {
            case 0:
                return List.of();
            case 1:
                return List.of(build.apply(contexts.get(0)));
            default:
                @SuppressWarnings("unchecked")
                N[] nodes = (N[]) new Object[contexts.size()];
                for (int i = 0; i < nodes.length; i++) {
                    nodes[i] = build.apply(contexts.get(i));
                }
                return List.of(nodes);
        }
    }

    /** The node of what may be left out: then the context is null. */
    static <C, N> Optional<N> optional(C context, Function<C, ? extends N> build) {
        return context == null ? Optional.empty() : Optional.of(build.apply(context));
    }

    protected final Span span(ParserRuleContext context) {
        return phrases.span(context.start, context.stop);
    }

    protected final Span span(Token first, Token last) {
        return phrases.span(first, last);
    }
}
