package arcomat.semantics;

import arcomat.model.Automaton;

/** One way to begin: an initial clause with what it sends and where the automaton is then. */
public record Start(Automaton.Initial initial, Output output, Configuration configuration) {}
