package arcomat.semantics.automaton;

import arcomat.model.Trace;
import arcomat.semantics.expression.Output;

/**
 * One way to go on: what is sent and where the automaton is afterwards.
 *
 * @param cause the transition, or the completion where none is enabled
 */
public record Reaction(Trace.Cause cause, Output output, Configuration next) {}
