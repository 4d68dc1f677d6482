package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.GivenArgumentContext;
import arcomat.syntax.antlr.ArcomatParser.TypeArgumentsContext;
import arcomat.syntax.antlr.ArcomatParser.WildcardArgumentContext;
import arcomat.tree.TypeArgument;
import arcomat.tree.TypeArgument.Given;
import arcomat.tree.TypeArgument.Wildcard;

import java.util.List;

/** What stands between the angle brackets of a type. */
final class TypeArgumentBuilder extends TreeBuilder<TypeArgument> {
    private final TypeBuilder types;

    TypeArgumentBuilder(SharedTexts texts, TypeBuilder types) {
        super(texts);
        this.types = types;
    }

    List<TypeArgument> arguments(TypeArgumentsContext context) {
        return context == null ? List.of() : buildAll(context.typeArgument());
    }

    @Override
    public TypeArgument visitGivenArgument(GivenArgumentContext context) {
        return new Given(span(context), types.build(context.type()));
    }

    @Override
    public TypeArgument visitWildcardArgument(WildcardArgumentContext context) {
        boolean upper = context.bound == null || context.bound.getText().equals("extends");
        return new Wildcard(span(context), upper, types.buildOptional(context.type()));
    }
}
