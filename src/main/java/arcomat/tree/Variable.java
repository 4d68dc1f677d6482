package arcomat.tree;

import arcomat.source.Span;

import java.util.Optional;

/** A declared variable with its initial value, if any. */
public record Variable(Span span, Name name, Optional<Expression> initial) implements Node {}
