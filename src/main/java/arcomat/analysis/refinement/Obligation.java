package arcomat.analysis.refinement;

import arcomat.source.Span;

/**
 * A promise that a model says it keeps: by a {@code refines} clause, or by an automaton on a
 * decomposed component.
 *
 * @param place what is to be shown to be right
 */
public record Obligation(Promise left, Promise right, Span place) {}
