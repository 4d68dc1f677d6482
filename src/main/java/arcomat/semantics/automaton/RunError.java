package arcomat.semantics.automaton;

import arcomat.model.Trace;

/**
 * One way in which a run ends: a transition goes wrong, or the completion forbids the input.
 *
 * @param cause the transition or the completion
 * @param message what goes wrong and where, in words
 */
public record RunError(Trace.Cause cause, String message) {}
