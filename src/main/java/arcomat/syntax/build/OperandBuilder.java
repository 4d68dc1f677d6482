package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.AccessSuffixContext;
import arcomat.syntax.antlr.ArcomatParser.NamePrimaryContext;
import arcomat.syntax.antlr.ArcomatParser.OperandContext;
import arcomat.syntax.antlr.ArcomatParser.SuffixContext;
import arcomat.tree.Expression;
import arcomat.tree.Expression.Call;
import arcomat.tree.Expression.JavaExpression;
import arcomat.tree.Expression.Reference;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Names, calls and what is joined to them by dots and brackets. */
final class OperandBuilder {
    private final NameBuilder names;
    private final ExpressionBuilder expressions;

    OperandBuilder(NameBuilder names, ExpressionBuilder expressions) {
        this.names = names;
        this.expressions = expressions;
    }

    Expression name(NamePrimaryContext context) {
        Name name = names.build(context.name());
        if (context.arguments() == null) {
            return new Reference(name.span(), new QualifiedName(name.span(), List.of(name)));
        }
        Span span = expressions.span(context);
        List<Expression> arguments = expressions.arguments(context.arguments());
        return new Call(span, Optional.empty(), name, arguments);
    }

    Expression operand(OperandContext context) {
        Expression result = expressions.build(context.primary());
        // "(a).b" is no qualified name, though its parentheses leave no node.
        boolean isName = context.primary() instanceof NamePrimaryContext;
        for (SuffixContext suffix : context.suffix()) {
            Span span = expressions.span(context.start, suffix.stop);
            result = join(span, result, isName, suffix);
        }
        return result;
    }

    private Expression join(Span span, Expression target, boolean isName, SuffixContext suffix) {
        if (!(suffix instanceof AccessSuffixContext access)) {
            return new JavaExpression(span, span.text());
        }
        Name name = names.build(access.name());
        if (access.arguments() != null) {
            List<Expression> arguments = expressions.arguments(access.arguments());
            return new Call(span, Optional.of(target), name, arguments);
        }
        return isName && target instanceof Reference reference
                ? new Reference(span, extended(span, reference.name(), name))
                : new JavaExpression(span, span.text());
    }

    private static QualifiedName extended(Span span, QualifiedName name, Name last) {
        List<Name> parts = new ArrayList<>(name.parts());
        parts.add(last);
        return new QualifiedName(span, parts);
    }
}
