/**
 * What one automaton can do, and what is known of that: its configurations are tried one by one,
 * breadth first, and what that leaves open is put to the solver. Knows no question in particular.
 */
package arcomat.analysis.automaton.exploration;
