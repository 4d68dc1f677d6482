package arcomat.tree;

import arcomat.source.Span;

import java.util.List;

/** Names joined by dots, at least one. */
public record QualifiedName(Span span, List<Name> parts) implements Node {
    /** The names joined by dots. */
    public String text() {
        if (parts.size() == 1) {
            return parts.get(0).text();
        }
        StringBuilder text = new StringBuilder(parts.get(0).text());
        for (Name part : parts.subList(1, parts.size())) {
            text.append('.').append(part.text());
        }
        return text.toString();
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
