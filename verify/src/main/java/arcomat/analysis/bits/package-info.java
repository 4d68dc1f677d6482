/**
 * Numbers as computers have them: expressions become circuits of bits, and a small solver says
 * which messages make them so. Operations are exact: products of messages as well, and how numbers
 * of floating point are rounded. Of the few that have no circuit, and of texts, it is known what is
 * the same.
 */
package arcomat.analysis.bits;
