package arcomat.tree;

import arcomat.source.Span;

import java.util.List;

/**
 * What can be read of a file with syntax errors: its whole elements.
 *
 * @param unit without the elements that have an error
 * @param gaps the texts that were left out, in no order
 */
public record Recovered(Unit unit, List<Span> gaps) {}
