package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.StereotypeContext;
import arcomat.syntax.antlr.ArcomatParser.StereotypesContext;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;

import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Optional;

/** Entries of {@code <<..>>} lists. */
final class StereotypeBuilder extends TreeBuilder<Stereotype> {
    private final NameBuilder names;

    StereotypeBuilder(SharedTexts texts, NameBuilder names) {
        super(texts);
        this.names = names;
    }

    List<Stereotype> stereotypes(StereotypesContext context) {
        return context == null ? List.of() : buildAll(context.stereotype());
    }

    @Override
    public Stereotype visitStereotype(StereotypeContext context) {
        return new Stereotype(span(context), names.build(context.name(0)), value(context));
    }

    private Optional<Name> value(StereotypeContext context) {
        if (context.literal() == null) {
            return names.buildOptional(context.word);
        }
        Token token = context.literal().kind;
        return Optional.of(new Name(span(token), Literals.unquoted(token)));
    }
}
