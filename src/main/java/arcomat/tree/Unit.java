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
    public Unit {
        imports = List.copyOf(imports);
        comments = List.copyOf(comments);
    }

    public SourceFile file() {
        return span.file();
    }

    /** The package as written, empty for the default package. */
    public String packageText() {
        return packageName.map(QualifiedName::text).orElse("");
    }

    /** The documentation comment that ends right before a node, white space aside. */
    public Optional<Comment> documentationOf(Node node) {
        Comment last = null;
        for (Comment comment : comments) {
            if (comment.span().end() > node.span().start()) {
                break;
            }
            last = comment;
        }
        return Optional.ofNullable(last)
                .filter(Comment::isDocumentation)
                .filter(c -> isBlank(c.span().end(), node.span().start()));
    }

    private boolean isBlank(int start, int end) {
        return file().text().substring(start, end).isBlank();
    }
}
