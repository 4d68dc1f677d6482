package arcomat.tree;

import arcomat.source.Span;

import java.util.List;

/** {@code T} or {@code T extends Bound & Bound}. */
public record TypeParameter(Span span, Name name, List<TypeReference> bounds) implements Node {}
