package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser.InstanceTypeContext;
import arcomat.syntax.antlr.ArcomatParser.NameContext;
import arcomat.syntax.antlr.ArcomatParser.PlainNameContext;
import arcomat.syntax.antlr.ArcomatParser.PrimitiveTypeContext;
import arcomat.syntax.antlr.ArcomatParser.QualifiedNameContext;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;

/** Names joined by dots. */
final class QualifiedNameBuilder extends TreeBuilder<QualifiedName> {
    private final NameBuilder names;

    QualifiedNameBuilder(SharedTexts texts, NameBuilder names) {
        super(texts);
        this.names = names;
    }

    @Override
    public QualifiedName visitQualifiedName(QualifiedNameContext context) {
        return of(names.buildAll(context.name()));
    }

    @Override
    public QualifiedName visitInstanceType(InstanceTypeContext context) {
        return of(names.buildAll(context.name()));
    }

    @Override
    public QualifiedName visitPlainName(PlainNameContext context) {
        List<Name> parts = new ArrayList<>();
        parts.add(names.name(context.start));
        for (NameContext name : context.name()) {
            parts.add(names.build(name));
        }
        return of(parts);
    }

    @Override
    public QualifiedName visitPrimitiveType(PrimitiveTypeContext context) {
        return of(List.of(names.name(context.start)));
    }

    QualifiedName of(List<Name> parts) {
        Span first = parts.get(0).span();
        Span span = parts.size() == 1 ? first : first.to(parts.get(parts.size() - 1).span());
        return new QualifiedName(span, parts);
    }
}
