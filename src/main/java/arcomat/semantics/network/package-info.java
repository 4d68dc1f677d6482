/**
 * How parts work together: elaborated into wires, ordered for a slice, or composed into one. Knows
 * how an expression is substituted, and no automaton.
 */
package arcomat.semantics.network;
