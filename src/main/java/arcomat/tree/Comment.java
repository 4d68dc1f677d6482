package arcomat.tree;

import arcomat.source.Span;

/** A comment with its delimiters. */
public record Comment(Span span, String text) implements Node {}
