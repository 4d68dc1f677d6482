/**
 * Questions of guests about automata, asked of what an analysis has explored. Knows nothing of the
 * limits and the order of analyses.
 */
package arcomat.pipeline.analysis.guest;
