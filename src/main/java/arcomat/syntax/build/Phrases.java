package arcomat.syntax.build;

import static arcomat.syntax.build.TreeBuilder.each;
import static arcomat.syntax.build.TreeBuilder.optional;

import arcomat.source.ComposedForm;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Expression;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.Stereotype;
import arcomat.tree.TypeReference;
import arcomat.tree.TypeReference.TypeArgument;
import arcomat.tree.Variable;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;
import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * What occurs in definitions of every kind: names, types, stereotypes, variables. Trees of large
 * models live long, so what is equal in one file is kept once: the texts of names and literals, and
 * the spans of nodes around a sole child.
 */
final class Phrases {
    final ExpressionBuilder expressions = new ExpressionBuilder(this);
    private final SourceFile file;
    private final UnaryOperator<Span> places;
    private final KnownTexts texts;
    private Span latest;
    private Span latestPlace;

    /**
     * @param places where what stands in the file is said to stand
     */
    Phrases(SourceFile file, UnaryOperator<Span> places) {
        this.file = file;
        this.places = places;
        this.texts = new KnownTexts(file.text());
        this.latest = file.span(0, 0);
        this.latestPlace = places.apply(latest);
    }

    Span wholeFile() {
        return places.apply(file.span(0, file.text().length()));
    }

    Span span(Token first, Token last) {
        Span written = written(first, last);
        if (latest != written) {
            latest = written;
            latestPlace = places.apply(written);
        }
        return latestPlace;
    }

    /** The place in the file itself, whatever it stands for. */
    private Span written(Token first, Token last) {
        int start = first.getStartIndex();
        int end = last.getStopIndex() + 1;
        return latest.start() == start && latest.end() == end ? latest : file.span(start, end);
    }

    /** What is written in the file. */
    String text(ParserRuleContext context) {
        return text(context.start, context.stop);
    }

    String text(Token first, Token last) {
        return written(first, last).text();
    }

    private Span span(ParserRuleContext context) {
        return span(context.start, context.stop);
    }

    /** The same, once for all that are equal. */
    String knownText(ParserRuleContext context) {
        return texts.of(written(context.start, context.stop));
    }

    // ---- names ----------------------------------------------------------------------------

    Name name(Token token) {
        return new Name(span(token, token), ComposedForm.of(texts.of(written(token, token))));
    }

    Name name(ArcomatParser.NameContext context) {
        return name(context.start);
    }

    Optional<Name> optionalName(ArcomatParser.NameContext context) {
        return optional(context, this::name);
    }

    List<Name> names(List<ArcomatParser.NameContext> contexts) {
        return each(contexts, this::name);
    }

    /** An element of an array is named by its number, however that is written. */
    Name place(ArcomatParser.PlaceContext context) {
        Name name = name(context.name());
        return context.index == null
                ? name
                : ArrayBuilder.element(span(context), name, ArrayBuilder.number(context.index));
    }

    List<Name> places(List<ArcomatParser.PlaceContext> contexts) {
        return each(contexts, this::place);
    }

    QualifiedName qualifiedPlace(ArcomatParser.QualifiedPlaceContext context) {
        return qualifiedName(places(context.place()));
    }

    List<QualifiedName> qualifiedPlaces(List<ArcomatParser.QualifiedPlaceContext> contexts) {
        return each(contexts, this::qualifiedPlace);
    }

    /** The elements of an array, or the one thing that is no array. */
    List<Name> declared(ArcomatParser.DeclaredContext context) {
        return context.size() == null
                ? List.of(name(context.name()))
                : elements(span(context), context, context.size());
    }

    List<Name> elements(
            Span span, ArcomatParser.DeclaredContext context, ArcomatParser.SizeContext size) {
        return ArrayBuilder.elements(span, name(context.name()), ArrayBuilder.number(size.count));
    }

    QualifiedName qualifiedName(ArcomatParser.QualifiedNameContext context) {
        return qualifiedName(names(context.name()));
    }

    List<QualifiedName> qualifiedNames(List<ArcomatParser.QualifiedNameContext> contexts) {
        return each(contexts, this::qualifiedName);
    }

    QualifiedName qualifiedName(List<Name> parts) {
        Span first = parts.get(0).span();
        Span span = parts.size() == 1 ? first : first.to(parts.get(parts.size() - 1).span());
        return new QualifiedName(span, parts);
    }

    private QualifiedName qualifiedName(ArcomatParser.PlainNameContext context) {
        List<Name> parts = new ArrayList<>(names(context.name()));
        parts.add(0, name(context.start));
        return qualifiedName(List.copyOf(parts));
    }

    // ---- types ----------------------------------------------------------------------------

    TypeReference type(ArcomatParser.TypeContext context) {
        QualifiedName name =
                context.qualifiedName() == null
                        ? primitive(context)
                        : qualifiedName(context.qualifiedName());
        return type(context, name, context.typeArguments(), context.typeSuffix());
    }

    TypeReference type(ArcomatParser.PlainTypeContext context) {
        QualifiedName name =
                context.plainName() == null
                        ? primitive(context)
                        : qualifiedName(context.plainName());
        return type(context, name, context.typeArguments(), context.typeSuffix());
    }

    TypeReference type(ArcomatParser.ObjectTypeContext context) {
        QualifiedName name = qualifiedName(context.qualifiedName());
        return type(context, name, context.typeArguments(), null);
    }

    TypeReference type(ArcomatParser.PrimitiveTypeContext context) {
        return type(context, primitive(context), null, null);
    }

    TypeReference type(ArcomatParser.InstanceTypeContext context) {
        return type(context, qualifiedName(names(context.name())), null, null);
    }

    /** The type that a name stands for alone. */
    TypeReference type(ArcomatParser.QualifiedNameContext context) {
        return type(context, qualifiedName(context), null, null);
    }

    List<TypeReference> types(List<ArcomatParser.TypeContext> contexts) {
        return each(contexts, this::type);
    }

    private QualifiedName primitive(ParserRuleContext context) {
        return qualifiedName(List.of(name(context.start)));
    }

    private TypeReference type(
            ParserRuleContext context,
            QualifiedName name,
            ArcomatParser.@Nullable TypeArgumentsContext arguments,
            ArcomatParser.@Nullable TypeSuffixContext suffix) {
        return new TypeReference(
                span(context),
                name,
                typeArguments(arguments),
                suffix instanceof ArcomatParser.RangeSuffixContext range
                        ? Optional.of(range(range))
                        : Optional.empty(),
                suffix instanceof ArcomatParser.ArraySuffixContext array
                        ? array.dimensions.size()
                        : 0);
    }

    private TypeReference.Range range(ArcomatParser.RangeSuffixContext context) {
        return new TypeReference.Range(
                span(context), expressions.build(context.low), expressions.build(context.high));
    }

    List<TypeArgument> typeArguments(ArcomatParser.@Nullable TypeArgumentsContext context) {
        return context == null ? List.of() : each(context.typeArgument(), this::typeArgument);
    }

    private TypeArgument typeArgument(ArcomatParser.TypeArgumentContext context) {
        if (context instanceof ArcomatParser.WildcardArgumentContext wildcard) {
            boolean upper = wildcard.bound == null || wildcard.bound.getText().equals("extends");
            return new TypeArgument.Wildcard(
                    span(context), upper, optional(wildcard.type(), this::type));
        }
        return new TypeArgument.Given(
                span(context), type(((ArcomatParser.GivenArgumentContext) context).type()));
    }

    // ---- stereotypes and variables --------------------------------------------------------

    List<Stereotype> stereotypes(ArcomatParser.StereotypesContext context) {
        return context == null ? List.of() : each(context.stereotype(), this::stereotype);
    }

    private Stereotype stereotype(ArcomatParser.StereotypeContext context) {
        Optional<Name> value =
                context.literal() == null
                        ? optionalName(context.word)
                        : Optional.of(unquoted(context.literal().kind));
        return new Stereotype(span(context), name(context.name(0)), value);
    }

    /** A string literal without its quotes, any other literal as written. */
    private Name unquoted(Token literal) {
        String text = literal.getText();
        return new Name(
                span(literal, literal),
                literal.getType() == ArcomatLexer.STRING
                        ? text.substring(1, text.length() - 1)
                        : text);
    }

    List<Variable> variables(List<ArcomatParser.VariableContext> contexts) {
        return contexts.stream().flatMap(each -> variables(each).stream()).toList();
    }

    private List<Variable> variables(ArcomatParser.VariableContext context) {
        return variables(
                span(context),
                context.declared(),
                optional(context.expression(), expressions::build));
    }

    List<Variable> variables(ArcomatParser.ValuedVariableContext context) {
        return variables(
                span(context),
                context.declared(),
                Optional.of(expressions.build(context.expression())));
    }

    /** All elements of an array begin with one value. */
    private List<Variable> variables(
            Span span, ArcomatParser.DeclaredContext declared, Optional<Expression> initial) {
        return declared(declared).stream().map(name -> new Variable(span, name, initial)).toList();
    }
}
