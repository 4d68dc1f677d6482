/**
 * What a component may do in one step: the step relation of its automata with their completions,
 * and its behaviour from start to start. The meaning of a model is said here.
 */
package arcomat.semantics.automaton;
