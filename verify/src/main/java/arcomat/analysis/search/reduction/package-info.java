/**
 * What cannot change the answer to a question about a network: parts outside of its cone, variables
 * that nobody reads, the places of equal parts. Errs on the side of keeping.
 */
package arcomat.analysis.search.reduction;
