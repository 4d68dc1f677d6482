package arcomat.tree;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/**
 * One file: header and definition.
 *
 * @param comments every comment of the file in text order
 */
public record Unit(
        Span span,
        Optional<QualifiedName> packageName,
        List<Import> imports,
        Definition definition,
        List<Comment> comments)
        implements Node {
    public SourceFile file() {
        return span.file();
    }

    /** The package as written, empty for the default package. */
    public String packageText() {
        return packageName.map(QualifiedName::text).orElse("");
    }

    /** A comment with its delimiters. */
    public record Comment(Span span, String text) implements Node {}

    /** {@code import a.b.C;} or, with a wildcard, {@code import a.b.*;}. */
    public record Import(Span span, QualifiedName name, boolean wildcard) implements Node {}
}
