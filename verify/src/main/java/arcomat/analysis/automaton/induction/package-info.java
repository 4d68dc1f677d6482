/**
 * What always holds in the states of an automaton, whatever is read: conditions over its variables
 * that its transitions keep. Solvers prove more with it, and traps are made of it.
 */
package arcomat.analysis.automaton.induction;
