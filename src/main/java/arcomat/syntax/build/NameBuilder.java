package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.NameContext;
import arcomat.tree.Name;

import org.antlr.v4.runtime.Token;

/** Names: one token each. */
final class NameBuilder extends TreeBuilder<Name> {
    NameBuilder(SharedTexts texts) {
        super(texts);
    }

    @Override
    public Name visitName(NameContext context) {
        return name(context.start);
    }

    Name name(Token token) {
        Span span = span(token);
        return new Name(span, texts.text(span));
    }
}
