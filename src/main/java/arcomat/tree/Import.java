package arcomat.tree;

import arcomat.source.Span;

/** {@code import a.b.C;} or, with a wildcard, {@code import a.b.*;}. */
public record Import(Span span, QualifiedName name, boolean wildcard) implements Node {}
