package arcomat.tree;

import arcomat.source.Span;

import java.util.Optional;

/** A configuration parameter of a component. */
public record Parameter(Span span, TypeReference type, Name name, Optional<Expression> initial)
        implements Node {}
