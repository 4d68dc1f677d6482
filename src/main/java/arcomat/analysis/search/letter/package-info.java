/**
 * Letters that look alike to all that read them are one; here is who looks, and what stands for
 * what nobody names.
 */
package arcomat.analysis.search.letter;
