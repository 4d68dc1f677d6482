package arcomat.tree;

import arcomat.source.Span;

/** A piece of a tree with the text it came from. */
public interface Node {
    Span span();
}
