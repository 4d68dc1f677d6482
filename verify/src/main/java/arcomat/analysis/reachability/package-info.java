/**
 * Whether some run of one automaton shows something, where variables and messages have too many
 * values to try: runs as formulas of whichever solver there is, a bounded search for them, and
 * k-induction to show that there are none. Knows no solver.
 */
package arcomat.analysis.reachability;
