/**
 * Whole numbers as computers have them: expressions become circuits of bits, and a small solver
 * says which messages make them so. All operations are exact, products of messages as well.
 */
@NullMarked
package arcomat.analysis.bits;

import org.jspecify.annotations.NullMarked;
