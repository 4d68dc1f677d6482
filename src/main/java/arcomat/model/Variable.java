package arcomat.model;

import arcomat.source.Span;

/**
 * A variable of an automaton, or a constant of a component.
 *
 * @param initial over parameters and constants; where the model gives none, the type's first value:
 *     0, false, the empty string, the first constant of an enum, the low end of a range without 0
 */
public record Variable(String name, Type type, Expression initial, Span span) {}
