package arcomat.tree;

import arcomat.source.SourceFile;
import arcomat.source.Span;

import java.util.List;
import java.util.Optional;

/**
 * One file: header and definition.
 *
 * @param comments every comment of the file in text order
 * @param spellings the words that may be read as others, in text order
 */
public record Unit(
        Span span,
        Optional<QualifiedName> packageName,
        List<Import> imports,
        Definition definition,
        List<Comment> comments,
        List<Spelling> spellings)
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

    /** A number or a name that may be read as another one. */
    public record Spelling(Span span, Kind kind) implements Node {
        /** Why it may be. */
        public enum Kind {
            /** A whole number that begins with 0 and has digits from 0 to 7. */
            OCTAL,
            /** A whole number that begins with 0 and has a digit 8 or 9: Java has none. */
            NOT_OCTAL,
            /** A name with letters of several scripts. */
            MIXED_SCRIPTS
        }
    }

    /** {@code import a.b.C;} or, with a wildcard, {@code import a.b.*;}. */
    public record Import(Span span, QualifiedName name, boolean wildcard) implements Node {}
}
