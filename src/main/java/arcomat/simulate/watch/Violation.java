package arcomat.simulate.watch;

import arcomat.model.Automaton;

/**
 * A requirement that a run does not keep.
 *
 * @param slice in which that is seen
 * @param message what was seen and what would have been allowed
 */
public record Violation(int slice, Automaton requirement, String message) {}
