package arcomat.syntax.build;

import arcomat.syntax.antlr.ArcomatParser.ArraySuffixContext;
import arcomat.syntax.antlr.ArcomatParser.InstanceTypeContext;
import arcomat.syntax.antlr.ArcomatParser.ObjectTypeContext;
import arcomat.syntax.antlr.ArcomatParser.PlainTypeContext;
import arcomat.syntax.antlr.ArcomatParser.PrimitiveTypeContext;
import arcomat.syntax.antlr.ArcomatParser.RangeSuffixContext;
import arcomat.syntax.antlr.ArcomatParser.TypeArgumentsContext;
import arcomat.syntax.antlr.ArcomatParser.TypeContext;
import arcomat.syntax.antlr.ArcomatParser.TypeSuffixContext;
import arcomat.tree.QualifiedName;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.Range;

import org.antlr.v4.runtime.ParserRuleContext;

import java.util.List;
import java.util.Optional;

/** Types. */
final class TypeBuilder extends TreeBuilder<TypeReference> {
    final TypeArgumentBuilder typeArguments;
    private final QualifiedNameBuilder qualifiedNames;
    private final ExpressionBuilder expressions;

    TypeBuilder(
            SharedTexts texts, QualifiedNameBuilder qualifiedNames, ExpressionBuilder expressions) {
        super(texts);
        this.typeArguments = new TypeArgumentBuilder(texts, this);
        this.qualifiedNames = qualifiedNames;
        this.expressions = expressions;
    }

    @Override
    public TypeReference visitType(TypeContext context) {
        return type(context, context.typeArguments(), context.typeSuffix());
    }

    @Override
    public TypeReference visitPlainType(PlainTypeContext context) {
        return type(context, context.typeArguments(), context.typeSuffix());
    }

    @Override
    public TypeReference visitObjectType(ObjectTypeContext context) {
        return type(context, context.typeArguments(), null);
    }

    @Override
    public TypeReference visitPrimitiveType(PrimitiveTypeContext context) {
        return named(context);
    }

    @Override
    public TypeReference visitInstanceType(InstanceTypeContext context) {
        return named(context);
    }

    private TypeReference named(ParserRuleContext context) {
        QualifiedName name = qualifiedNames.build(context);
        return new TypeReference(name.span(), name, List.of(), Optional.empty(), 0);
    }

    private TypeReference type(
            ParserRuleContext context, TypeArgumentsContext arguments, TypeSuffixContext suffix) {
        return new TypeReference(
                span(context),
                qualifiedNames.build((ParserRuleContext) context.getChild(0)),
                typeArguments.arguments(arguments),
                suffix instanceof RangeSuffixContext range
                        ? Optional.of(range(range))
                        : Optional.empty(),
                suffix instanceof ArraySuffixContext array ? array.getChildCount() / 2 : 0);
    }

    private Range range(RangeSuffixContext context) {
        return new Range(
                span(context), expressions.build(context.low), expressions.build(context.high));
    }
}
