package arcomat.model;

import arcomat.source.Span;

/**
 * A condition about what a component shows and keeps, at the end of every slice.
 *
 * @param condition over the ports of the component, those of its parts, by {@code part.port}, the
 *     variables of its automata, constants and parameters
 */
public record Invariant(String name, Expression condition, Span span) {}
