/**
 * What became of promises from one version of a component to the next: edits, changes of meaning,
 * gates.
 */
package arcomat.analysis.evolution;
