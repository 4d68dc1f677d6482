/**
 * Numbers as computers have them: expressions become circuits of bits, and a small solver says
 * which messages make them so. All operations are exact: products of messages as well, and how
 * numbers of floating point are rounded.
 */
package arcomat.analysis.bits;
