package arcomat.tree;

import arcomat.source.Span;

import java.util.List;
import java.util.stream.Collectors;

/** Names joined by dots, at least one. */
public record QualifiedName(Span span, List<Name> parts) implements Node {
    public QualifiedName {
        parts = List.copyOf(parts);
    }

    /** The names joined by dots. */
    public String text() {
        if (parts.size() == 1) {
            return parts.get(0).text();
        }
        return parts.stream().map(Name::text).collect(Collectors.joining("."));
    }

    public Name last() {
        return parts.get(parts.size() - 1);
    }

    public boolean isSimple() {
        return parts.size() == 1;
    }

    @Override
    public String toString() {
        return text();
    }
}
