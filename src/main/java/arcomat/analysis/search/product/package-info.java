/**
 * Trace inclusion between two sides, pair by pair, with a simulation where that is enough; and
 * certificates that say why it holds, which are checked by a second look.
 */
package arcomat.analysis.search.product;
