package arcomat.tree;

import arcomat.source.Span;

/** One identifier; keywords may serve as names. */
public record Name(Span span, String text) implements Node {
    @Override
    public String toString() {
        return text;
    }
}
