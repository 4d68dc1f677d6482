package arcomat.semantics.automaton;

import arcomat.model.Automaton;
import arcomat.semantics.expression.Output;

/** One way to begin: an initial clause with what it sends and where the automaton is then. */
public record Start(Automaton.Initial initial, Output output, Configuration configuration) {}
