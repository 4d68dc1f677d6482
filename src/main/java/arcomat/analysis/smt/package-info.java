/**
 * Runs of one automaton as formulas over integers and Booleans, for variables and messages that
 * have too many values to try: a bounded search for runs, and k-induction to show that there are
 * none. The only place that knows the solver, SMTInterpol, which runs inside this virtual machine.
 */
package arcomat.analysis.smt;
