/**
 * Expressions as formulas over integers and Booleans, for variables and messages that have too many
 * values to try: along the runs of one automaton, and for the letters that tell some steps apart.
 * The only place that knows the solver, SMTInterpol, which runs inside this virtual machine.
 */
package arcomat.analysis.smt;
