/**
 * Comparisons of networks as bits, for {@link arcomat.analysis.symbolic}: from the tables of what
 * the parts may do and from the steps of the right side, so that models have one meaning only.
 */
package arcomat.analysis.search.encoding;
