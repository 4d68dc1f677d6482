package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Call;
import arcomat.tree.Expression.Reference;
import arcomat.tree.Expression.Unary;
import arcomat.tree.Expression.UnaryOperator;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;
import arcomat.tree.TestSuite.Message;
import arcomat.tree.TestSuite.PortStream;
import arcomat.tree.TestSuite.Repeat;
import arcomat.tree.TestSuite.StreamElement;
import arcomat.tree.TestSuite.Tick;

import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Optional;

/** Streams of stream tests. */
final class StreamBuilder extends TreeBuilder<StreamElement> {
    private static final String TICK = "Tk";

    StreamBuilder(Phrases phrases) {
        super(phrases);
    }

    PortStream portStream(ArcomatParser.PortStreamContext context) {
        return new PortStream(
                span(context),
                phrases.qualifiedPlace(context.qualifiedPlace()),
                elements(context.stream()));
    }

    PortStream eventStream(ArcomatParser.EventStreamContext context) {
        return new PortStream(
                span(context),
                phrases.qualifiedPlace(context.qualifiedPlace()),
                context.stream() == null
                        ? List.of(build(context.streamElement()))
                        : elements(context.stream()));
    }

    private List<StreamElement> elements(ArcomatParser.StreamContext context) {
        return buildAll(context.streamElement());
    }

    @Override
    public StreamElement visitSingleMessage(ArcomatParser.SingleMessageContext context) {
        return build(context.message());
    }

    @Override
    public StreamElement visitRepeatedMessage(ArcomatParser.RepeatedMessageContext context) {
        return new Repeat(
                span(context),
                ArrayBuilder.number(context.count),
                List.of(build(context.message())));
    }

    @Override
    public StreamElement visitRepeatedGroup(ArcomatParser.RepeatedGroupContext context) {
        return new Repeat(
                span(context),
                ArrayBuilder.number(context.count),
                buildAll(context.streamElement()));
    }

    @Override
    public StreamElement visitSingleGroup(ArcomatParser.SingleGroupContext context) {
        return new Repeat(span(context), 1, buildAll(context.streamElement()));
    }

    @Override
    public StreamElement visitLiteralMessage(ArcomatParser.LiteralMessageContext context) {
        Expression literal = phrases.expressions.build(context.literal());
        return message(span(context), context.minus, literal);
    }

    private static Message message(Span span, Token minus, Expression value) {
        return new Message(
                span, minus == null ? value : new Unary(span, UnaryOperator.MINUS, value));
    }

    @Override
    public StreamElement visitNameMessage(ArcomatParser.NameMessageContext context) {
        QualifiedName name = phrases.qualifiedName(context.qualifiedName());
        Span span = span(context);
        if (context.arguments() != null) {
            return message(span, context.minus, call(context, name));
        }
        return name.text().equals(TICK) && context.minus == null
                ? new Tick(span)
                : message(span, context.minus, new Reference(name.span(), name));
    }

    private Expression call(ArcomatParser.NameMessageContext context, QualifiedName name) {
        List<Name> before = name.parts().subList(0, name.parts().size() - 1);
        Optional<Expression> target = Optional.empty();
        if (!before.isEmpty()) {
            QualifiedName owner = phrases.qualifiedName(before);
            target = Optional.of(new Reference(owner.span(), owner));
        }
        return new Call(
                span(context),
                target,
                name.last(),
                phrases.expressions.arguments(context.arguments()));
    }
}
