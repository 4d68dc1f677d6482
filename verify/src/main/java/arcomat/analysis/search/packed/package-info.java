/**
 * Networks as bits: configurations packed into words, and the step of the whole from remembered
 * steps of its parts. Says the same as the unfolding, which is the reference.
 */
package arcomat.analysis.search.packed;
